#include "core/estimation/box.h"

namespace handmap {

Box boxOf(const Rectangle& r) {
  return {r.centre, r.heading, {r.width / 2.0, r.depth / 2.0, r.width / 2.0, r.depth / 2.0}};
}

std::size_t Box::quartersTo(double heading_rad) const {
  const long quarters = std::lround(normalizedAngle(heading_rad - heading) / (kPi / 2.0));
  return static_cast<std::size_t>((quarters + 4) % 4);
}

Box Box::renumbered(std::size_t quarters) const {
  const double turn = static_cast<double>(quarters) * kPi / 2.0;
  Box result{pivot, normalizedAngle(heading + turn), {}};
  for (std::size_t wall = 0; wall < 4; ++wall) result.reach[wall] = reach[(wall + quarters) % 4];
  return result;
}

}  // namespace handmap
