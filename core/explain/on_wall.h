// When a ray ended on a wall: the one rule for what is drawn as seen, and for what tells why a wall
// stands where it does.
#pragma once

#include <cmath>
#include <optional>

#include "core/explain/constants.h"
#include "core/geometry/polygon.h"

namespace handmap {

struct OnWall {
  double at_m;      ///< along the wall, from its first corner
  double offset_m;  ///< across it, outwards
  double cosine;    ///< of incidence
};

/// `wall`: of a footprint, counter-clockwise. nullopt where the ray came from inside, or ended
/// elsewhere.
inline std::optional<OnWall> onWall(const Segment& wall, const Vec2& end, const Vec2& direction,
                                    double tolerance_m = explain::kOnWall_m) {
  const double length = wall.length();
  if (length <= 0.0) return std::nullopt;
  const Vec2 along = (wall.b - wall.a) / length;
  const Vec2 outwards = -perpendicular(along);
  const Vec2 from_a = end - wall.a;
  const OnWall on{from_a.dot(along), from_a.dot(outwards), -direction.dot(outwards)};
  if (on.cosine < explain::kLeastCosine || on.at_m < 0.0 || on.at_m > length ||
      std::abs(on.offset_m) > tolerance_m) {
    return std::nullopt;
  }
  return on;
}

}  // namespace handmap
