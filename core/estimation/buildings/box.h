// A building as the estimator finds it: a box of any heading.
#pragma once

#include <array>

#include "core/geometry/polygon.h"

namespace handmap {

/// Wall k has the outward normal unitVector(heading + k · π/2) and lies `reach[k]`
/// metres from the pivot along it.
struct Box {
  Vec2 pivot = Vec2::Zero();
  double heading = 0.0;
  std::array<double, 4> reach{};

  Pose2 frame() const { return {pivot.x(), pivot.y(), heading}; }
  std::array<Vec2, 4> normals() const {
    const Vec2 u = unitVector(heading);
    const Vec2 v = perpendicular(u);
    return {u, v, -u, -v};
  }
  Vec2 normal(std::size_t wall) const { return normals()[wall]; }
  Rectangle rectangle() const {
    const Vec2 u = unitVector(heading);
    const Vec2 centre =
        pivot + 0.5 * (reach[0] - reach[2]) * u + 0.5 * (reach[1] - reach[3]) * perpendicular(u);
    return {centre, reach[0] + reach[2], reach[1] + reach[3], heading};
  }
  /// Where walls k and k + 1 meet, as shares of the sides: (0, 0) is where 2 and 3 do.
  static const Vec2& share(std::size_t corner) { return kCorners[corner]; }
  Vec2 corner(std::size_t corner) const { return at(kCorners[corner]); }
  std::array<Vec2, 4> corners() const {
    const Vec2 u = unitVector(heading);
    return {at(kCorners[0], u), at(kCorners[1], u), at(kCorners[2], u), at(kCorners[3], u)};
  }
  Polygon polygon() const {
    const std::array<Vec2, 4> all = corners();
    return {all.begin(), all.end()};
  }

  Vec2 at(const Vec2& share) const { return at(share, unitVector(heading)); }
  // The same, and others, with unitVector(heading) told by who asks for many.
  Vec2 at(const Vec2& share, const Vec2& u) const {
    return pivot + (share.x() * (reach[0] + reach[2]) - reach[2]) * u +
           (share.y() * (reach[1] + reach[3]) - reach[3]) * perpendicular(u);
  }
  Vec2 shareAt(const Vec2& point, const Vec2& u) const;
  /// How a point with these shares moves along `direction` with each reach.
  std::array<double, 4> slopes(const Vec2& share, const Vec2& direction) const {
    return slopes(share, direction, unitVector(heading));
  }
  std::array<double, 4> slopes(const Vec2& share, const Vec2& direction, const Vec2& u) const {
    const double x = direction.dot(u);
    const double y = direction.dot(perpendicular(u));
    return {x * share.x(), y * share.y(), -x * (1.0 - share.x()), -y * (1.0 - share.y())};
  }

  /// By how many sides the numbering must move for the heading to be nearest to `heading_rad`.
  std::size_t quartersTo(double heading_rad) const;
  /// The same box, its sides numbered from `quarters` on.
  Box renumbered(std::size_t quarters) const;
  Box nearestTo(double heading_rad) const { return renumbered(quartersTo(heading_rad)); }

 private:
  inline static const std::array<Vec2, 4> kCorners = {Vec2(1.0, 1.0), Vec2(0.0, 1.0),
                                                      Vec2(0.0, 0.0), Vec2(1.0, 0.0)};
};

Box boxOf(const Rectangle& rectangle);

}  // namespace handmap
