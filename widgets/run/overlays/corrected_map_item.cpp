#include "widgets/run/overlays/corrected_map_item.h"

#include <QPainter>

#include "core/map/certainty.h"
#include "widgets/run/overlays/scene_points.h"

namespace handmap {

namespace {

const QList<qreal> kDashes = {5.0, 4.0};  // pen widths

}  // namespace

void CorrectedMapItem::setColours(const Colours& colours) {
  colours_ = &colours;
  update();
}

QPen CorrectedMapItem::unseenPen(const Colours& colours) {
  QPen pen = colours.pen(Role::Corrected);
  pen.setWidthF(0.75 * pen.widthF());
  pen.setDashPattern(kDashes);
  return pen;
}

void CorrectedMapItem::setMap(const Map& map) {
  prepareGeometryChange();
  seen_.clear();
  unseen_.clear();
  doubtful_.clear();
  outlines_.clear();
  bounds_ = {};
  for (const Building& building : map.buildings) {
    if (!building.estimate) continue;
    const QPolygonF outline = toScene(building.footprint());
    const std::vector<SideEstimate> walls = wallsOf(building);
    for (qsizetype i = 0; i < outline.size(); ++i) {
      (walls[static_cast<std::size_t>(i)].seen ? seen_ : unseen_)
          .append({outline[i], outline[(i + 1) % outline.size()]});
    }
    outlines_.insert(QString::fromStdString(building.id), outline);
    bounds_ |= outline.boundingRect();
    if (doubtOf(building) <= 0.0) continue;
    doubtful_.addPolygon(outline);
    doubtful_.closeSubpath();
  }
  bounds_.adjust(-2.0, -2.0, 2.0, 2.0);
}

void CorrectedMapItem::setSelected(const QStringList& ids) {
  selected_ = ids;
  update();
}

void CorrectedMapItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  const QTransform to_device = painter->worldTransform();
  painter->setWorldTransform({});  // a hatching is of pixels
  painter->fillPath(to_device.map(doubtful_), colours_->brush(Role::Doubtful));
  painter->setWorldTransform(to_device);
  painter->setBrush(colours_->brush(Role::CorrectedBand));
  painter->setPen(Qt::NoPen);
  for (const QString& id : selected_) painter->drawPolygon(outlines_.value(id));
  painter->setBrush(Qt::NoBrush);
  QPen pen = colours_->pen(Role::Corrected);
  pen.setCapStyle(Qt::SquareCap);  // closes the corners
  if (on_picture_) {
    painter->setPen(colours_->casing(pen));
    painter->drawLines(seen_);
    painter->drawLines(unseen_);
  }
  painter->setPen(pen);
  painter->drawLines(seen_);
  painter->setPen(unseenPen(*colours_));
  painter->drawLines(unseen_);
}

}  // namespace handmap
