#include "core/map_match/wall_map.h"

#include <algorithm>
#include <cmath>

#include "core/map_match/constants.h"

namespace handmap {

using namespace map_match;

namespace {

/// Along each wall, the first and last half a step from its ends.
void addWalls(const Polygon& outline, std::vector<ScanPoint>& points) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2& from = outline[(i + outline.size() - 1) % outline.size()];
    const Vec2 along = outline[i] - from;
    const Vec2 outwards = -perpendicular(along.normalized());
    const auto steps = static_cast<int>(std::ceil(along.norm() / kSpacing_m));
    for (int k = 0; k < steps; ++k) points.push_back({from + (k + 0.5) / steps * along, outwards});
  }
}

}  // namespace

WallMap::WallMap(const Map& map) {
  for (const Building& building : map.buildings) {
    buildings_.push_back(building.footprint());
    addWalls(buildings_.back(), walls_);
  }
}

const PointMap& WallMap::around(const Vec2& here) {
  if ((here - centre_).norm() < kStale_m) return near_;
  centre_ = here;
  std::vector<ScanPoint> near;
  std::copy_if(walls_.begin(), walls_.end(), std::back_inserter(near),
               [&](const ScanPoint& p) { return (p.at - here).norm() < kNear_m; });
  near_ = PointMap();
  near_.add(near, 0);
  return near_;
}

int WallMap::buildingsAt(const std::vector<ScanPoint>& points, double near_m, int least) const {
  Bounds bounds{Vec2::Constant(1e9), Vec2::Constant(-1e9)};
  for (const ScanPoint& p : points) {
    bounds.low = bounds.low.cwiseMin(p.at);
    bounds.high = bounds.high.cwiseMax(p.at);
  }
  return static_cast<int>(
      std::count_if(buildings_.begin(), buildings_.end(), [&](const Polygon& outline) {
        if (!boundsOf(outline).overlaps(bounds)) return false;
        return std::count_if(points.begin(), points.end(), [&](const ScanPoint& p) {
                 return distanceTo(outline, p.at) < near_m;
               }) >= least;
      }));
}

}  // namespace handmap
