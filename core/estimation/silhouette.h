// Where a building ends for a robot: the bearings at which its returns stop.
#pragma once

#include <vector>

#include "core/estimation/box_score.h"

namespace handmap {

struct SeenEnd {
  std::size_t corner = 0;  ///< of the box
  double bearing = 0.0;    ///< measured, robot frame
  double sigma = 0.0;      ///< radians
};

/// The corners of a building, outside of which the robot stands, between a wall that faces it and
/// one that does not; only those whose bearing the returns tell.
std::vector<SeenEnd> silhouette(const Box& box, const Frame& frame, const SensorModel& sensor);

}  // namespace handmap
