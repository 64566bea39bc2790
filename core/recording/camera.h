// A rectified stereo camera on a robot.
#pragma once

namespace handmap {

/// Pose of the left camera in the robot frame: metres, radians. Pitch is positive downwards, yaw
/// positive to the left; the pan of a view adds to yaw.
struct CameraMount {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double pitch = 0.0;
  double yaw = 0.0;
};

/// Both images share focal lengths and rows. Pixels and metres.
struct StereoCamera {
  double fx = 0.0;
  double fy = 0.0;
  double cx = 0.0;
  double cy = 0.0;
  double baseline = 0.0;  ///< > 0: the right camera is to the right of the left one
  CameraMount mount;
};

}  // namespace handmap
