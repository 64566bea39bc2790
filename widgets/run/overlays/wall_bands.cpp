#include "widgets/run/overlays/wall_bands.h"

#include <cmath>

#include "core/map/certainty.h"

namespace handmap {

namespace {

Vec2 outwardNormal(const Vec2& a, const Vec2& b) { return -perpendicular((b - a).normalized()); }

}  // namespace

std::vector<Polygon> wallBands(const Building& building) {
  const Polygon footprint = building.footprint();
  const std::vector<SideEstimate> walls = wallsOf(building);
  std::vector<double> outwards;
  std::vector<double> inwards;
  for (const auto& [sigma, seen] : walls) {
    outwards.push_back(seen ? sigma : 0.0);
    inwards.push_back(-outwards.back());
  }
  const Polygon outer = offsetWalls(footprint, outwards);
  const Polygon inner = offsetWalls(footprint, inwards);
  std::vector<Polygon> bands;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    if (!walls[i].seen || walls[i].sigma <= 0.0) continue;
    const std::size_t next = (i + 1) % walls.size();
    const Vec2& a = footprint[i];
    const Vec2& b = footprint[next];
    const Vec2 aside = walls[i].sigma * outwardNormal(a, b);
    // Surer of nothing than the building is wide: the corners of the walls say no more.
    const bool mitred = !outer.empty() && !inner.empty();
    bands.push_back(mitred ? Polygon{inner[i], inner[next], outer[next], outer[i]}
                           : Polygon{a - aside, b - aside, b + aside, a + aside});
  }
  return bands;
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
