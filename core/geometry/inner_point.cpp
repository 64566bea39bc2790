#include "core/geometry/inner_point.h"

#include <limits>

namespace handmap {

namespace {

constexpr int kCells = 12;  // of the first search, along each side of the box
constexpr int kRounds = 4;  // each searches a ninth of the area of the one before
constexpr double kFiner = 3.0;

/// From the nearest edge, metres; negative outside.
double depthOf(const Polygon& polygon, const Vec2& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    least =
        std::min(least, distanceTo(Segment{polygon[i], polygon[(i + 1) % polygon.size()]}, point));
  return contains(polygon, point) ? least : -least;
}

}  // namespace

Vec2 innerPoint(const Polygon& polygon) {
  Vec2 best = centroid(polygon);
  if (polygon.size() < 4 || isConvex(polygon)) return best;
  const Bounds box = boundsOf(polygon);
  double depth = depthOf(polygon, best);
  Vec2 middle = 0.5 * (box.low + box.high);
  Vec2 half = 0.5 * (box.high - box.low);
  for (int round = 0; round < kRounds; ++round) {
    for (int i = 0; i <= kCells; ++i) {
      for (int j = 0; j <= kCells; ++j) {
        const Vec2 at =
            middle + half.cwiseProduct(Vec2(2.0 * i / kCells - 1.0, 2.0 * j / kCells - 1.0));
        const double deep = depthOf(polygon, at);
        if (deep <= depth) continue;
        depth = deep;
        best = at;
      }
    }
    middle = best;
    half /= kFiner;
  }
  return best;
}

}  // namespace handmap
