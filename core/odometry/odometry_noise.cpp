#include "core/odometry/odometry_noise.h"

#include <cmath>

namespace handmap {

Eigen::Vector3d OdometryNoise::sigmaOf(const Pose2& motion) const {
  const double length = motion.position().norm();
  const double heading = std::sqrt(heading_variance_per_m * length) +
                         heading_per_rad * std::abs(motion.heading) + least_heading;
  return {along_per_m * length + least_m, aside_per_m * length + least_m, heading};
}

}  // namespace handmap
