#include "core/method/wheel_uncertainty.h"

#include <cmath>

#include <Eigen/Geometry>

#include "core/odometry/constants.h"

namespace handmap {

Eigen::Matrix3d rotation(double heading_rad) {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  rotation.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(heading_rad).toRotationMatrix();
  return rotation;
}

/// A step adds its noise; the heading before it swings the end of it.
void WheelUncertainty::add(const Odometry& odometry) {
  if (!last_) {
    last_ = odometry;
    return;
  }
  const Pose2 motion = between(last_->pose, odometry.pose);
  // A metre at a time, as it drifts, however often it is asked.
  const double length = motion.position().norm();
  const Eigen::Vector3d variance(kWheels.along_per_m * kWheels.along_per_m * length,
                                 kWheels.aside_per_m * kWheels.aside_per_m * length,
                                 kWheels.heading_variance_per_m * length +
                                     std::pow(kWheels.heading_per_rad * motion.heading, 2));
  Eigen::Matrix3d slope = Eigen::Matrix3d::Identity();
  slope.topRightCorner<2, 1>() = perpendicular(odometry.pose.position() - last_->pose.position());
  const Eigen::Matrix3d turn = rotation(last_->pose.heading);
  covariance_ = slope * covariance_ * slope.transpose() +
                turn * variance.asDiagonal() * turn.transpose() + odometry.guessed - last_->guessed;
  last_ = odometry;
}

}  // namespace handmap
