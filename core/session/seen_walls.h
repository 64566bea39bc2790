// Which walls of a map one observation saw.
#pragma once

#include <vector>

#include "core/map/map.h"
#include "core/perception/scan.h"
#include "core/session/wall_story.h"

namespace handmap {

/// The part of a wall on which rays ended.
struct SeenWall {
  std::size_t building;
  std::size_t wall;  ///< from corner `wall` of the footprint to the next
  Segment piece;
  int rays;
};

/// Walls that face the robot and have returns, taken for walls, within `tolerance_m`.
std::vector<SeenWall> seenWalls(const Map& map, const Pose2& robot, const Scan& scan,
                                double tolerance_m = kOnWall_m);

}  // namespace handmap
