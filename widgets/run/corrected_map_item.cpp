#include "widgets/run/corrected_map_item.h"

#include <QPainter>

#include "core/map/certainty.h"
#include "widgets/run/scene_points.h"

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
  for (const Building& building : map.buildings) {
    if (!building.estimate) continue;
    const QPolygonF outline = toScene(building.footprint());
    const std::vector<SideEstimate> walls = wallsOf(building);
    for (qsizetype i = 0; i < outline.size(); ++i) {
      QPainterPath& path = walls[static_cast<std::size_t>(i)].seen ? seen_ : unseen_;
      if (path.currentPosition() != outline[i] || path.isEmpty()) path.moveTo(outline[i]);
      path.lineTo(outline[(i + 1) % outline.size()]);
    }
    if (doubtOf(building) <= 0.0) continue;
    doubtful_.addPolygon(outline);
    doubtful_.closeSubpath();
  }
  bounds_ = (seen_.boundingRect() | unseen_.boundingRect()).adjusted(-2.0, -2.0, 2.0, 2.0);
}

void CorrectedMapItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->save();
  const QTransform to_device = painter->worldTransform();
  painter->setWorldTransform({});  // a hatching is of pixels
  painter->setRenderHint(QPainter::Antialiasing);
  painter->fillPath(to_device.map(doubtful_), colours_->brush(Role::Doubtful));
  painter->setBrush(Qt::NoBrush);
  painter->setPen(colours_->pen(Role::Corrected));
  painter->drawPath(to_device.map(seen_));
  painter->setPen(unseenPen(*colours_));
  painter->drawPath(to_device.map(unseen_));
  painter->restore();
}

}  // namespace handmap
