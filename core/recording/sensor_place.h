// Where a range sensor or camera is on the robot, as a person says it.
#pragma once

#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "core/recording/observation.h"

namespace handmap {

/// "0.3,0,1.7" or, with degrees to the left, "0.3,0,1.7,90": x, y, z in the robot's frame, at most
/// 50 m. Throws Usage.
Eigen::Isometry3d parseSensorPlace(std::string_view text);

/// Points of a sensor in the robot's frame; what was not measured stays a direction.
std::vector<RangePoint> placedOn(const Eigen::Isometry3d& sensor, std::vector<RangePoint> points);

}  // namespace handmap
