#include "widgets/canvas/underlay_item.h"

#include <QDir>
#include <QFileInfo>
#include <QImageReader>
#include <QPainter>
#include <QPointer>
#include <QThreadPool>

#include "core/map/references.h"
#include "widgets/canvas/symbols.h"

namespace handmap {

namespace {

constexpr int kMaxSide = 6000;               ///< larger pictures are read smaller
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
  QHash<QString, Picture> kept;
  for (const Underlay& underlay : document_.map().underlays) {
    const QString path = pathOf(underlay);
    if (kept.contains(path)) continue;
    if (!pictures_.contains(path)) load(path);
    kept.insert(path, pictures_.value(path));
  }
  pictures_ = std::move(kept);
  updateBounds();
}

void UnderlayItem::reload() {
  pictures_.clear();
  rebuild();
}

void UnderlayItem::load(const QString& path) {
  QThreadPool::globalInstance()->start([path, map_file = document_.origin().toStdString(),
                                        anywhere = document_.trustsReferences(),
                                        item = QPointer<UnderlayItem>(this)] {
    Picture picture = anywhere || staysInside({{}, path.toStdString()}, map_file)
                          ? read(path)
                          : Picture{{}, {}, tr("outside of the folder of the drawing"), false};
    QMetaObject::invokeMethod(qApp, [path, item, picture = std::move(picture)] {
      if (!item || !item->pictures_.contains(path)) return;
      item->pictures_[path] = picture;
      item->updateBounds();
    });
  });
}

UnderlayItem::Picture UnderlayItem::read(const QString& path) {
  Picture picture;
  picture.loading = false;
  if (!QFileInfo(path).isFile()) {  // one could wait for a pipe for ever
    picture.problem = QFileInfo::exists(path) ? tr("not a file") : tr("no such file");
    return picture;
  }
  QImageReader reader(path);
  picture.size = reader.size();
  if (picture.size.width() > kMaxSide || picture.size.height() > kMaxSide)
    reader.setScaledSize(picture.size.scaled(kMaxSide, kMaxSide, Qt::KeepAspectRatio));
  picture.image = reader.read().convertToFormat(QImage::Format_ARGB32_Premultiplied);
  if (picture.image.isNull()) picture.problem = reader.errorString();
  if (!picture.size.isValid()) picture.size = picture.image.size();
  return picture;
}

void UnderlayItem::updateBounds() {
  prepareGeometryChange();
  bounds_ = {};
  for (const Underlay& underlay : document_.map().underlays) {
    const Picture picture = pictures_.value(pathOf(underlay));
    const QSize size = picture.image.isNull() ? kPlaceholderSize : picture.size;
    bounds_ |= toMap(underlay).mapRect(QRectF(QPointF(), size));
  }
  update();
}

void UnderlayItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  for (const Underlay& underlay : document_.map().underlays) {
    const Picture picture = pictures_.value(pathOf(underlay));
    painter->save();
    painter->setTransform(toMap(underlay), true);
    if (picture.image.isNull()) {
      paintPlaceholder(*painter, QRectF(QPointF(), kPlaceholderSize), underlay, picture);
    } else {
      painter->setOpacity(underlay.opacity);
      painter->setRenderHint(QPainter::SmoothPixmapTransform);
      painter->drawImage(QRectF(QPointF(), picture.size), picture.image);
    }
    painter->restore();
  }
}

void UnderlayItem::paintPlaceholder(QPainter& painter, const QRectF& pixels,
                                    const Underlay& underlay, const Picture& picture) const {
  painter.setPen(colours_->pen(picture.loading ? Role::Axis : Role::Doubtful));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(pixels);
  if (!picture.loading) {
    painter.drawLine(pixels.topLeft(), pixels.bottomRight());
    painter.drawLine(pixels.topRight(), pixels.bottomLeft());
  }
  const QPointF centre = painter.worldTransform().map(pixels.center());
  painter.setWorldTransform({});
  const QString image = QString::fromStdString(underlay.image);
  const QString text =
      picture.loading ? tr("Reading %1 …").arg(image) : tr("%1: %2").arg(image, picture.problem);
  paintLabel(painter, centre, text, *colours_, true);
}

}  // namespace handmap
