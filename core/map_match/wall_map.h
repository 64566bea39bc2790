// The walls of a map, to lay scans on.
#pragma once

#include <vector>

#include "core/map/map.h"
#include "core/trajectory/point_map.h"

namespace handmap {

class WallMap {
 public:
  explicit WallMap(const Map& map);

  /// Points every 0.25 m of the walls within 60 m of `here`, facing outwards; valid until the next
  /// call.
  const PointMap& around(const Vec2& here);
  /// How many buildings have at least `least` of the points within `near_m` of their walls.
  int buildingsAt(const std::vector<ScanPoint>& points, double near_m, int least) const;

 private:
  std::vector<Polygon> buildings_;
  std::vector<ScanPoint> walls_;  ///< of all buildings
  PointMap near_;
  Vec2 centre_ = Vec2::Constant(1e9);
};

}  // namespace handmap
