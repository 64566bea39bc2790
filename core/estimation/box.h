// A building as the estimator finds it: four walls of one heading.
#pragma once

#include <array>

#include "core/geometry/polygon.h"

namespace handmap {

/// Wall k has the outward normal unitVector(heading + k · π/2) and lies `reach[k]` metres from the
/// pivot along it.
struct Box {
  Vec2 pivot = Vec2::Zero();
  double heading = 0.0;
  std::array<double, 4> reach{};

  Vec2 normal(std::size_t wall) const {
    return unitVector(heading + static_cast<double>(wall) * kPi / 2.0);
  }
  Rectangle rectangle() const {
    const Vec2 u = unitVector(heading);
    const Vec2 centre =
        pivot + 0.5 * (reach[0] - reach[2]) * u + 0.5 * (reach[1] - reach[3]) * perpendicular(u);
    return {centre, reach[0] + reach[2], reach[1] + reach[3], heading};
  }
  /// The corner between wall k and wall k + 1.
  Vec2 corner(std::size_t wall) const {
    const std::size_t next = (wall + 1) % 4;
    return pivot + reach[wall] * normal(wall) + reach[next] * normal(next);
  }
  /// By how many walls the numbering must move for the heading to be nearest to `heading_rad`.
  std::size_t quartersTo(double heading_rad) const;
  /// The same box, its walls numbered from `quarters` on.
  Box renumbered(std::size_t quarters) const;
  Box nearestTo(double heading_rad) const { return renumbered(quartersTo(heading_rad)); }
};

Box boxOf(const Rectangle& rectangle);

}  // namespace handmap
