#include "core/method/wheel_uncertainty.h"

#include <cmath>

#include "core/geometry/pose_covariance.h"
#include "core/odometry/constants.h"

namespace handmap {

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
  covariance_ = swungBy(odometry.pose.position() - last_->pose.position(), covariance_) +
                turnedBy(last_->pose.heading, variance.asDiagonal()) + odometry.guessed -
                last_->guessed;
  last_ = odometry;
}

}  // namespace handmap
