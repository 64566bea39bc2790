// When a ray ended on a wall: the one rule for what is drawn as seen, and for what tells why a wall
// stands where it does.
#pragma once

#include <cmath>
#include <optional>

#include "core/geometry/polygon.h"

namespace handmap {

/// Rays that place a wall: the least cosine of incidence (flatter ones tell nothing across) and how
/// surely the return is of a wall.
inline constexpr double kLeastCosine = 0.1;
inline constexpr double kLeastWall = 0.05;
/// Returns farther from a wall are not of it, metres.
inline constexpr double kOnWall_m = 0.5;

struct OnWall {
  double at_m;      ///< along the wall, from its first corner
  double offset_m;  ///< across it, outwards
  double cosine;    ///< of incidence
};

/// `wall`: of a footprint, counter-clockwise. nullopt where the ray came from inside, or ended
/// elsewhere.
inline std::optional<OnWall> onWall(const Segment& wall, const Vec2& end, const Vec2& direction,
                                    double tolerance_m = kOnWall_m) {
  const double length = wall.length();
  if (length <= 0.0) return std::nullopt;
  const Vec2 along = (wall.b - wall.a) / length;
  const Vec2 outwards = -perpendicular(along);
  const Vec2 from_a = end - wall.a;
  const OnWall on{from_a.dot(along), from_a.dot(outwards), -direction.dot(outwards)};
  if (on.cosine < kLeastCosine || on.at_m < 0.0 || on.at_m > length ||
      std::abs(on.offset_m) > tolerance_m) {
    return std::nullopt;
  }
  return on;
}

}  // namespace handmap
