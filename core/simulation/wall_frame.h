// Along a wall and outwards from it.
#pragma once

#include "core/simulation/route.h"

namespace handmap {

/// From its first corner; the outline it belongs to runs counter-clockwise.
struct WallFrame {
  Vec2 corner;
  Vec2 along;
  Vec2 out;
  double length;

  WallFrame(const Vec2& a, const Vec2& b)
      : corner(a),
        along((b - a).normalized()),
        out(-perpendicular(along)),
        length((b - a).norm()) {}
  Vec2 at(double s, double outwards) const { return corner + s * along + outwards * out; }
  double heading() const { return std::atan2(along.y(), along.x()); }
};

/// The wall whose middle is nearest to the route.
inline WallFrame frontOf(const Polygon& outline, const Route& route) {
  const auto away = [&](std::size_t k) {
    return std::abs(route.project((outline[k] + outline[(k + 1) % outline.size()]) / 2.0).offset);
  };
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < outline.size(); ++k) {
    if (away(k) < away(nearest)) nearest = k;
  }
  return {outline[nearest], outline[(nearest + 1) % outline.size()]};
}

}  // namespace handmap
