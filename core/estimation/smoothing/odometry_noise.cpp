#include "core/estimation/smoothing/odometry_noise.h"

#include <cmath>

namespace handmap {

Eigen::Vector3d OdometryNoise::sigmaOf(const Pose2& motion) const {
  const double length = std::hypot(motion.x, motion.y);
  const double heading = std::sqrt(heading_variance_per_m * length) +
                         heading_per_rad * std::abs(motion.heading) + least_heading;
  return {length_per_m * length + least_length_m, side_per_m * length + least_length_m, heading};
}

}  // namespace handmap
