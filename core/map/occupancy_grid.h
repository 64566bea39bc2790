// A map as robots' planners take it: cells that are in a building, and cells that are not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/map/map.h"

namespace handmap {

struct OccupancyGrid {
  Vec2 origin = Vec2::Zero();  ///< of the first cell's corner, map frame
  double cell_m = 0.25;
  std::size_t columns = 0;          ///< along x
  std::size_t rows = 0;             ///< along y
  std::vector<std::uint8_t> cells;  ///< row by row: 1 in a building
  bool operator==(const OccupancyGrid&) const = default;
};

/// All buildings and the start with a margin around. It keeps its place while they move a little.
/// Cells are larger than asked where there would be more than a million.
OccupancyGrid occupancyOf(const Map& map, double cell_m = 0.25);

}  // namespace handmap
