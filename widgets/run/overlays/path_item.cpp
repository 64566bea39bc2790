#include "widgets/run/overlays/path_item.h"

#include <QPainter>
#include <QStyleOptionGraphicsItem>
#include <algorithm>

#include "widgets/run/overlays/scene_points.h"

namespace handmap {

namespace {

constexpr double kApartPx = 1.0;  // nobody sees corners that are nearer

/// Without the corners that are nearer than so much to the one before; both ends stay.
QPolygonF thinned(const QPolygonF& trajectory, double apart) {
  QPolygonF kept;
  for (const QPointF& point : trajectory) {
    const QPointF step = kept.isEmpty() ? QPointF() : point - kept.last();
    if (kept.isEmpty() || QPointF::dotProduct(step, step) >= apart * apart) kept << point;
  }
  if (!trajectory.isEmpty() && kept.last() != trajectory.last()) kept << trajectory.last();
  return kept;
}

}  // namespace

void PathItem::setColours(const Colours& colours) {
  colours_ = &colours;
  update();
}

void PathItem::setPoses(const std::vector<StampedPose>& poses) {
  prepareGeometryChange();
  line_.clear();
  line_.reserve(static_cast<qsizetype>(poses.size()));
  for (const StampedPose& stamped : poses) line_ << toScene(stamped.pose.position());
  line_bounds_ = line_.boundingRect();
}

void PathItem::setBuildings(const std::vector<Building>& buildings) {
  prepareGeometryChange();
  outlines_.clear();
  outlines_bounds_ = {};
  for (const Building& building : buildings) {
    const QPolygonF outline = toScene(building.footprint());
    appendSides(outline, outlines_);
    outlines_bounds_ |= outline.boundingRect();
  }
}

void PathItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const double pixels_per_metre =
      QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter->worldTransform());
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(colours_->pen(role_));
  painter->drawLines(outlines_);
  painter->drawPolyline(thinned(line_, kApartPx / std::max(pixels_per_metre, 1e-6)));
}

}  // namespace handmap
