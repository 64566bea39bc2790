#include "core/estimation/buildings/box.h"

namespace handmap {

Box boxOf(const Rectangle& r) {
  return {r.centre, r.heading, {r.width / 2.0, r.depth / 2.0, r.width / 2.0, r.depth / 2.0}};
}

std::size_t Box::quartersTo(double heading_rad) const {
  const long quarters = std::lround(normalizedAngle(heading_rad - heading) / (kPi / 2.0));
  return static_cast<std::size_t>((quarters + 4) % 4);
}

Box Box::renumbered(std::size_t quarters) const {
  if (quarters == 0) return *this;
  const double turn = static_cast<double>(quarters) * kPi / 2.0;
  Box result{pivot, normalizedAngle(heading + turn), {}};
  for (std::size_t wall = 0; wall < 4; ++wall) result.reach[wall] = reach[(wall + quarters) % 4];
  return result;
}

Vec2 Box::shareAt(const Vec2& point, const Vec2& u) const {
  return {(u.dot(point - pivot) + reach[2]) / (reach[0] + reach[2]),
          (perpendicular(u).dot(point - pivot) + reach[3]) / (reach[1] + reach[3])};
}

}  // namespace handmap
