#include "widgets/canvas/underlay_item.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QPainter>
#include <QPointer>
#include <QThreadPool>

#include "core/base/error.h"
#include "core/map/references.h"
#include "widgets/canvas/symbols.h"

namespace handmap {

namespace {

constexpr QSize kPlaceholderSize(400, 300);  ///< pixels, while the real size is unknown

/// From pixels of the picture, rows downwards, to the map.
QTransform toMap(const Underlay& underlay) {
  QTransform transform;
  transform.translate(underlay.x, underlay.y);
  transform.rotateRadians(underlay.heading);
  transform.scale(underlay.metres_per_pixel, -underlay.metres_per_pixel);
  return transform;
}

}  // namespace

UnderlayItem::UnderlayItem(const MapDocument& document) : document_(document) { rebuild(); }

void UnderlayItem::setColours(const Colours& colours) {
  colours_ = &colours;
  update();
}

QString UnderlayItem::pathOf(const Underlay& underlay) const {
  return QFileInfo(document_.origin())
      .absoluteDir()
      .absoluteFilePath(QString::fromStdString(underlay.image));
}

void UnderlayItem::rebuild() {
  QHash<QString, Entry> kept;
  for (const Underlay& underlay : document_.map().underlays) {
    const QString path = pathOf(underlay);
    if (kept.contains(path)) continue;
    if (!entries_.contains(path)) load(path);
    kept.insert(path, entries_.value(path));
  }
  entries_ = std::move(kept);
  updateBounds();
}

void UnderlayItem::reload() {
  entries_.clear();
  rebuild();
}

void UnderlayItem::load(const QString& path) {
  QThreadPool::globalInstance()->start([path, map_file = document_.origin().toStdString(),
                                        anywhere = document_.trustsReferences(),
                                        item = QPointer<UnderlayItem>(this)] {
    Entry entry = anywhere || staysInside({{}, path.toStdString()}, map_file)
                      ? read(path)
                      : Entry{{}, tr("outside of the folder of the drawing"), false};
    QMetaObject::invokeMethod(qApp, [path, item, entry = std::move(entry)] {
      if (!item || !item->entries_.contains(path)) return;
      item->entries_[path] = entry;
      item->updateBounds();
    });
  });
}

UnderlayItem::Entry UnderlayItem::read(const QString& path) {
  Entry entry;
  entry.loading = false;
  try {
    entry.picture = readPicture(path);
    entry.picture.image.convertTo(QImage::Format_ARGB32_Premultiplied);
  } catch (const Error& error) {
    entry.problem = QString::fromUtf8(error.what());
    if (entry.problem.startsWith(path + u':')) entry.problem.remove(0, path.size() + 2);
  } catch (const std::bad_alloc&) {
    entry.problem = tr("there is not enough memory for it");
  }
  return entry;
}

const std::vector<Underlay>& UnderlayItem::shown() const {
  return preview_ ? *preview_ : document_.map().underlays;
}

void UnderlayItem::setPreview(const MapChange* preview) {
  auto wanted = preview ? preview->underlays : std::nullopt;
  if (wanted == preview_) return;
  preview_ = std::move(wanted);
  updateBounds();
}

QSize UnderlayItem::sizeOf(const Underlay& underlay) const {
  const Picture& picture = entries_.value(pathOf(underlay)).picture;
  return picture.image.isNull() ? kPlaceholderSize : picture.size;
}

QSize UnderlayItem::sizeOf(std::size_t place) const {
  return sizeOf(document_.map().underlays.at(place));
}

QRectF UnderlayItem::boundsOf(std::size_t place) const {
  const Underlay& underlay = document_.map().underlays.at(place);
  return toMap(underlay).mapRect(QRectF(QPointF(), sizeOf(underlay)));
}

void UnderlayItem::updateBounds() {
  prepareGeometryChange();
  bounds_ = {};
  for (const Underlay& underlay : shown())
    if (!underlay.flags.hidden)
      bounds_ |= toMap(underlay).mapRect(QRectF(QPointF(), sizeOf(underlay)));
  update();
}

void UnderlayItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  for (const Underlay& underlay : shown()) {
    if (underlay.flags.hidden) continue;
    const Entry entry = entries_.value(pathOf(underlay));
    painter->save();
    painter->setTransform(toMap(underlay), true);
    if (entry.picture.image.isNull()) {
      paintPlaceholder(*painter, QRectF(QPointF(), kPlaceholderSize), underlay, entry);
    } else {
      painter->setOpacity(underlay.opacity);
      painter->setRenderHint(QPainter::SmoothPixmapTransform);
      painter->drawImage(QRectF(QPointF(), entry.picture.size), entry.picture.image);
    }
    painter->restore();
  }
}

void UnderlayItem::paintPlaceholder(QPainter& painter, const QRectF& pixels,
                                    const Underlay& underlay, const Entry& entry) const {
  painter.setPen(colours_->pen(entry.loading ? Role::Axis : Role::Doubtful));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(pixels);
  if (!entry.loading) {
    painter.drawLine(pixels.topLeft(), pixels.bottomRight());
    painter.drawLine(pixels.topRight(), pixels.bottomLeft());
  }
  const QPointF centre = painter.worldTransform().map(pixels.center());
  painter.setWorldTransform({});
  const QString image = QString::fromStdString(underlay.image);
  const QString text =
      entry.loading ? tr("Reading %1 …").arg(image) : tr("%1: %2").arg(image, entry.problem);
  paintLabel(painter, centre, text, *colours_, true);
}

}  // namespace handmap
