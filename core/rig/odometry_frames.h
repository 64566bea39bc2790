// What a robot calls the frames of its odometry.
#pragma once

#include <string>

#include "core/geometry/pose2.h"

namespace handmap {

/// By default as REP 105 has them.
struct OdometryFrames {
  std::string odometry = "odom";
  std::string base = "base_link";
  /// Of the robot's odometry frame in the rig's, which goes on where a base begins anew.
  Pose2 origin;
  bool operator==(const OdometryFrames&) const = default;
};

}  // namespace handmap
