// Odometry that is bent so that it leads through poses that somebody has given.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/recording/trajectory.h"

namespace handmap {

/// One σ of what a person says of (x, y, heading), metres and radians. Choice: on a map of houses,
/// by an arrow that is dragged.
inline Eigen::Vector3d handSigma() { return {2.0, 2.0, toRadians(10.0)}; }

/// From the start to the first given pose, and from each to the next, what odometry and given pose
/// differ by is spread over the way: first the turn, then what is left of the position. After the
/// last one the odometry goes on as it is.
class GivenPoses {
 public:
  GivenPoses() = default;  ///< none: nothing is bent
  /// `odometry`: that of the run, from its start at least to the last given pose. `start`: the
  /// robot's pose, map frame, where the odometry is `start_odometry`. `given`: map frame,
  /// increasing in time. Throws BadInput where `odometry` does not reach a given pose.
  GivenPoses(const Pose2& start, const Pose2& start_odometry,
             const std::vector<StampedPose>& odometry, const std::vector<StampedPose>& given);

  /// The same odometry frame.
  Pose2 operator()(double time_s, const Pose2& odometry) const;
  /// Of the poses given until then, as Odometry::guessed has it.
  Eigen::Matrix3d variance(double time_s) const;

 private:
  Pose2 start_;  ///< of the odometry frame, map frame
  std::vector<double> given_s_;
  std::vector<StampedPose> corrections_;  ///< what turns a laid pose into a bent one, map frame
};

}  // namespace handmap
