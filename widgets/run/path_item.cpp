#include "widgets/run/path_item.h"

#include <QPainter>

#include "widgets/run/scene_points.h"

namespace handmap {

void PathItem::setColours(const Colours& colours) { setPen(colours.pen(role_)); }

void PathItem::setPoses(const std::vector<StampedPose>& poses) {
  way_.clear();
  if (!poses.empty()) way_.moveTo(toScene(poses.front().pose.position()));
  for (const StampedPose& stamped : poses) way_.lineTo(toScene(stamped.pose.position()));
  join();
}

void PathItem::setBuildings(const std::vector<Building>& buildings) {
  outlines_.clear();
  for (const Building& building : buildings) {
    outlines_.addPolygon(toScene(building.footprint()));
    outlines_.closeSubpath();
  }
  join();
}

void PathItem::join() {
  QPainterPath path = way_;
  path.addPath(outlines_);
  setPath(path);
}

void PathItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) {
  painter->setRenderHint(QPainter::Antialiasing);
  QGraphicsPathItem::paint(painter, option, widget);
}

}  // namespace handmap
