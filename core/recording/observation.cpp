#include "core/recording/observation.h"

#include <algorithm>
#include <cmath>

namespace handmap {

RangePoint notMeasured(double bearing_rad, float z) {
  constexpr double kAtRobot_m = 0.01;
  const Vec2 at = kAtRobot_m * unitVector(bearing_rad);
  return {static_cast<float>(at.x()), static_cast<float>(at.y()), z, 0.0F};
}

bool isMeasured(const RangePoint& point) { return std::hypot(point.x, point.y) >= kOwnBody_m; }

void SeenPoints::add(const View& view) {
  if (!view.ids.empty()) ids.resize(points.size());
  points.insert(points.end(), view.points->begin(), view.points->end());
  ids.insert(ids.end(), view.ids.begin(), view.ids.end());
  if (!ids.empty()) ids.resize(points.size());
}

bool seesAnything(const Observation& observation) {
  return std::any_of(observation.views.begin(), observation.views.end(), [](const View& view) {
    if (!view.points) return !view.left.empty();
    return std::any_of(view.points->begin(), view.points->end(), isMeasured);
  });
}

}  // namespace handmap
