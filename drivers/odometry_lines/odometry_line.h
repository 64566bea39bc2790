// What a self-made base sends of its odometry: one pose a line, in either of two forms.
//
//   odom,12.345,1.50,-0.20,0.7854            t, x, y, yaw
//   odom,12.345,1.50,-0.20,0.7854*5A         the same with a checksum: the XOR of all bytes before
//   *
//   {"t":12.345,"x":1.5,"y":-0.2,"yaw":0.7854}
//   look                                     or {"look":true}: the head is to look around
//
// t: seconds of the base's own clock; x, y: metres; yaw: radians, counter-clockwise.
#pragma once

#include <string_view>

#include "core/geometry/pose2.h"

namespace handmap {

struct OdometryLine {
  double stamp_s = 0.0;
  Pose2 pose;
};

bool asksToLook(std::string_view line);
/// Throws BadInput.
OdometryLine parseOdometryLine(std::string_view line);

}  // namespace handmap
