#include "widgets/canvas/hit_test.h"

#include <cmath>
#include <limits>

namespace handmap {

namespace {

bool isOnRoute(const std::vector<Vec2>& route, const Vec2& position, double reach) {
  for (std::size_t i = 1; i < route.size(); ++i)
    if (distanceTo(Segment{route[i - 1], route[i]}, position) <= reach) return true;
  return route.size() == 1 && (route.front() - position).norm() <= reach;
}

bool isInside(const Bounds& box, const Vec2& point) {
  return (box.low.array() <= point.array()).all() && (point.array() <= box.high.array()).all();
}

/// Whether the pointer may meet the objects of a layer.
bool isOpen(const LayerStates& layers, DrawingLayer layer) {
  return !stateOf(layers, layer).hidden && !stateOf(layers, layer).locked;
}

}  // namespace

QString objectAt(const MapDocument& document, const Vec2& position, double reach) {
  const Map& map = document.map();
  const LayerStates layers = map.layers;
  for (const Landmark& landmark : map.landmarks)
    if (isOpen(layers, DrawingLayer::Landmarks) && !landmark.flags.hidden &&
        (landmark.position - position).norm() <= 1.5 * reach)
      return QString::fromStdString(landmark.id);
  if (map.start && isOpen(layers, DrawingLayer::Start) &&
      (map.start->position() - position).norm() <= 1.5 * reach)
    return kStartKey;
  if (isOpen(layers, DrawingLayer::Route) && isOnRoute(map.route, position, reach))
    return kRouteKey;
  if (!isOpen(layers, DrawingLayer::Buildings)) return {};

  const Building* best = nullptr;
  double best_area = std::numeric_limits<double>::infinity();
  const Bounds around{position.array() - reach, position.array() + reach};
  for (const std::size_t i : document.buildingIndex().touching(around)) {
    const Building& building = map.buildings[i];
    if (building.flags.hidden) continue;
    const Polygon footprint = building.footprint();
    if (distanceTo(footprint, position) > reach) continue;
    const double area = std::abs(signedArea(footprint));
    if (area > best_area) continue;
    best = &building;
    best_area = area;
  }
  return best ? QString::fromStdString(best->id) : QString();
}

QStringList objectsIn(const MapDocument& document, const Bounds& box) {
  const Map& map = document.map();
  QStringList keys;
  const LayerStates layers = map.layers;
  for (const std::size_t i : document.buildingIndex().touching(box)) {
    const Building& building = map.buildings[i];
    if (isOpen(layers, DrawingLayer::Buildings) && !building.flags.hidden)
      keys << QString::fromStdString(building.id);
  }
  for (const Landmark& landmark : map.landmarks)
    if (isOpen(layers, DrawingLayer::Landmarks) && !landmark.flags.hidden &&
        isInside(box, landmark.position))
      keys << QString::fromStdString(landmark.id);
  if (map.start && isOpen(layers, DrawingLayer::Start) && isInside(box, map.start->position()))
    keys << kStartKey;
  for (const Vec2& point : map.route) {
    if (!isOpen(layers, DrawingLayer::Route) || !isInside(box, point)) continue;
    keys << kRouteKey;
    break;
  }
  return keys;
}

}  // namespace handmap
