// A building as the estimator finds it: a box, or what fills a part of it, of any heading.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/geometry/polygon.h"

namespace handmap {

/// Corners as shares of the sides of a box, counter-clockwise: (0, 0) is where its walls 2 and 3
/// meet. At most kMostWalls.
using Outline = std::vector<Vec2>;
inline constexpr std::size_t kMostWalls = 16;  // choice: arrays on the stack

/// Side k of the box has the outward normal unitVector(heading + k · π/2) and lies `reach[k]`
/// metres from the pivot along it.
struct Box {
  Vec2 pivot = Vec2::Zero();
  double heading = 0.0;
  std::array<double, 4> reach{};
  std::shared_ptr<const Outline> outline;  ///< nullptr: the box itself, wall k is side k

  Pose2 frame() const { return {pivot.x(), pivot.y(), heading}; }
  Vec2 sideNormal(std::size_t side) const {
    return unitVector(heading + static_cast<double>(side) * kPi / 2.0);
  }
  Rectangle rectangle() const {
    const Vec2 u = unitVector(heading);
    const Vec2 centre =
        pivot + 0.5 * (reach[0] - reach[2]) * u + 0.5 * (reach[1] - reach[3]) * perpendicular(u);
    return {centre, reach[0] + reach[2], reach[1] + reach[3], heading};
  }
  /// Of the box: between side k and side k + 1.
  Vec2 boxCorner(std::size_t side) const { return at(kBoxCorners[side]); }
  std::array<Vec2, 4> boxCorners() const {
    const Vec2 u = unitVector(heading);
    return {at(kBoxCorners[0], u), at(kBoxCorners[1], u), at(kBoxCorners[2], u),
            at(kBoxCorners[3], u)};
  }

  std::size_t walls() const { return outline ? outline->size() : 4; }
  /// Wall i runs from corner i − 1 to corner i.
  const Vec2& share(std::size_t corner) const {
    return outline ? (*outline)[corner] : kBoxCorners[corner];
  }
  Vec2 corner(std::size_t corner) const { return at(share(corner)); }
  Vec2 normal(std::size_t wall) const {
    if (!outline) return sideNormal(wall);
    const Vec2 begin = corner((wall + walls() - 1) % walls());
    return -perpendicular((corner(wall) - begin).normalized());
  }
  Polygon polygon() const;

  Vec2 at(const Vec2& share) const { return at(share, unitVector(heading)); }
  // The same, and others, with unitVector(heading) told by who asks for many.
  Vec2 at(const Vec2& share, const Vec2& u) const {
    return pivot + (share.x() * (reach[0] + reach[2]) - reach[2]) * u +
           (share.y() * (reach[1] + reach[3]) - reach[3]) * perpendicular(u);
  }
  Vec2 shareAt(const Vec2& point) const { return shareAt(point, unitVector(heading)); }
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
  /// The same box, without its outline, its sides numbered from `quarters` on.
  Box renumbered(std::size_t quarters) const;
  Box nearestTo(double heading_rad) const { return renumbered(quartersTo(heading_rad)); }

 private:
  inline static const std::array<Vec2, 4> kBoxCorners = {Vec2(1.0, 1.0), Vec2(0.0, 1.0),
                                                         Vec2(0.0, 0.0), Vec2(1.0, 0.0)};
};

Box boxOf(const Rectangle& rectangle);

}  // namespace handmap
