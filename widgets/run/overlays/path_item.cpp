#include "widgets/run/overlays/path_item.h"

#include <QPainter>
#include <QStyleOptionGraphicsItem>
#include <algorithm>

#include "widgets/run/overlays/scene_points.h"

namespace handmap {

namespace {

constexpr double kApartPx = 1.0;  // nobody sees corners that are nearer

/// Without the corners that are nearer than so much to the one before; both ends stay.
QPolygonF thinned(const QPolygonF& way, double apart) {
  QPolygonF kept;
  for (const QPointF& point : way) {
    const QPointF step = kept.isEmpty() ? QPointF() : point - kept.last();
    if (kept.isEmpty() || QPointF::dotProduct(step, step) >= apart * apart) kept << point;
  }
  if (!way.isEmpty() && kept.last() != way.last()) kept << way.last();
  return kept;
}

}  // namespace

void PathItem::setColours(const Colours& colours) {
  colours_ = &colours;
  update();
}

void PathItem::setPoses(const std::vector<StampedPose>& poses) {
  prepareGeometryChange();
  way_.clear();
  way_.reserve(static_cast<qsizetype>(poses.size()));
  for (const StampedPose& stamped : poses) way_ << toScene(stamped.pose.position());
  way_bounds_ = way_.boundingRect();
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
  painter->drawPolyline(thinned(way_, kApartPx / std::max(pixels_per_metre, 1e-6)));
}

}  // namespace handmap
