// What the occupancy grid of a robot tells of the ground.
#pragma once

#include <vector>

#include "core/geometry/pose2.h"

namespace handmap {

/// Metres of the grid's own frame.
struct SeenGround {
  double cell_m = 0.05;
  std::vector<Vec2> edges;  ///< middles of occupied cells beside one that is not
  std::vector<Vec2> free;   ///< middles of cells that were seen to be free, one in 0.5 m at least
};

}  // namespace handmap
