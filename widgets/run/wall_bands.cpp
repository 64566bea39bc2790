#include "widgets/run/wall_bands.h"

#include <cmath>

namespace handmap {

namespace {

Vec2 outwardNormal(const Vec2& a, const Vec2& b) { return -perpendicular((b - a).normalized()); }

}  // namespace

std::vector<double> wallSigmas(const Building& building) {
  const Polygon footprint = building.footprint();
  std::vector<double> sigmas(footprint.size(), 0.0);
  if (!building.estimate) return sigmas;
  const Estimate& estimate = *building.estimate;
  const Vec2 along = unitVector(building.box().heading);
  for (std::size_t i = 0; i < footprint.size(); ++i) {
    const Vec2 normal = outwardNormal(footprint[i], footprint[(i + 1) % footprint.size()]);
    sigmas[i] = std::hypot(normal.x() * estimate.sigma_x, normal.y() * estimate.sigma_y,
                           0.5 * normal.dot(along) * estimate.sigma_width);
  }
  return sigmas;
}

Polygon offsetWalls(const Polygon& footprint, const std::vector<double>& offsets_m) {
  const std::size_t count = footprint.size();
  Polygon moved(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = (i + count - 1) % count;
    const Vec2 n0 = outwardNormal(footprint[before], footprint[i]);
    const Vec2 n1 = outwardNormal(footprint[i], footprint[(i + 1) % count]);
    const double turn = cross(n0, n1);
    if (std::abs(turn) < 0.05) {  // nearly straight on: the walls have no useful intersection
      moved[i] = footprint[i] + 0.5 * (offsets_m[before] * n0 + offsets_m[i] * n1);
      continue;
    }
    // The point p with n0·p = offset 0 and n1·p = offset 1, seen from the corner.
    moved[i] = footprint[i] +
               (offsets_m[before] * -perpendicular(n1) + offsets_m[i] * perpendicular(n0)) / turn;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    if ((footprint[next] - footprint[i]).dot(moved[next] - moved[i]) <= 0.0) return {};
  }
  return moved;
}

}  // namespace handmap
