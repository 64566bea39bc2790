// Where a building ends for a robot: the bearings at which its returns stop.
#pragma once

#include <vector>

#include "core/estimation/buildings/box_view.h"

namespace handmap {

struct SeenEnd {
  std::size_t corner = 0;  ///< of the box
  double bearing = 0.0;    ///< measured, robot frame
  double sigma = 0.0;      ///< radians
};

/// A ray that passes near the end of a wall.
struct RayBeside {
  double outwards;  ///< bearing from the corner, radians: on the wall where it is less than 0
  float distance;   ///< to the wall or its continuation, metres; infinite where it meets neither
  float slack;      ///< see SensorModel
  Sight sight;
};

/// A corner of a building, outside of which the robot stands, between a wall that faces it and one
/// that does not.
struct VisibleEnd {
  std::size_t corner;           ///< of the box
  double bearing;               ///< of the corner, robot frame
  double sign;                  ///< 1 where the left is outwards, else -1
  double distance;              ///< of the corner
  std::vector<RayBeside> rays;  ///< from inside to outside
};

std::vector<VisibleEnd> visibleEnds(const Box& box, const Frame& frame, const SensorModel& sensor);

/// Only those whose bearing the returns tell.
std::vector<SeenEnd> silhouette(const Box& box, const Frame& frame, const SensorModel& sensor);

}  // namespace handmap
