// Where a ray meets walls and round things. Metres; directions are unit vectors.
#pragma once

#include <algorithm>
#include <limits>

#include "core/geometry/polygon.h"

namespace handmap {

inline constexpr double kNoHit = std::numeric_limits<double>::infinity();

/// Distance from `origin` along `direction` to the segment; kNoHit where the ray misses it.
inline double rayToSegment(const Vec2& origin, const Vec2& direction, const Segment& wall) {
  const Vec2 along = wall.b - wall.a;
  const double denominator = cross(direction, along);
  if (denominator == 0.0) return kNoHit;
  const Vec2 to_wall = wall.a - origin;
  const double distance = cross(to_wall, along) / denominator;
  const double share = cross(to_wall, direction) / denominator;
  return distance >= 0.0 && share >= 0.0 && share <= 1.0 ? distance : kNoHit;
}

/// Where a ray enters and leaves, metres from its origin.
struct Crossing {
  double in = kNoHit;
  double out = 0.0;
};

/// Of a circle; kNoHit from inside.
inline Crossing rayThroughCircle(const Vec2& origin, const Vec2& direction, const Vec2& centre,
                                 double radius) {
  const Vec2 to_centre = centre - origin;
  const double nearest = to_centre.dot(direction);
  const double squared = radius * radius - to_centre.squaredNorm() + nearest * nearest;
  if (squared < 0.0) return {};
  const double half = std::sqrt(squared);
  return nearest >= half ? Crossing{nearest - half, nearest + half} : Crossing{};
}

/// Of a convex polygon, from outside.
inline Crossing rayThrough(const Vec2& origin, const Vec2& direction, const Polygon& convex) {
  Crossing crossing{kNoHit, 0.0};
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Segment edge{convex[i], convex[(i + 1) % convex.size()]};
    const double distance = rayToSegment(origin, direction, edge);
    if (distance == kNoHit) continue;
    crossing.in = std::min(crossing.in, distance);
    crossing.out = std::max(crossing.out, distance);
  }
  return crossing;
}

}  // namespace handmap
