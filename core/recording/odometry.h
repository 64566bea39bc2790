// A pose by odometry, and how much of it is a guess.
#pragma once

#include <Eigen/Core>

#include "core/geometry/pose2.h"

namespace handmap {

struct Odometry {
  Odometry() = default;
  // A pose that was measured.
  Odometry(const Pose2& measured) : pose(measured) {}  // NOLINT(google-explicit-constructor)
  Odometry(const Pose2& at, const Eigen::Matrix3d& variance) : pose(at), guessed(variance) {}

  Pose2 pose;  ///< odometry frame
  /// Variance of (x, y, heading) that has come together since the first pose, odometry frame: what
  /// it grows by from one pose to another is beyond the noise of the motion between them.
  Eigen::Matrix3d guessed = Eigen::Matrix3d::Zero();
};

}  // namespace handmap
