#include "core/estimation/smoothing/odometry_factor.h"

#include "core/pose_graph/motion_factor.h"

namespace handmap {

using namespace smoothing;

Factor<3, 2 * kPoseSize + 1> odometryFactor(const Frame& from, const Frame& to, double scale,
                                            const OdometryNoise& noise) {
  const Pose2 counted = between(from.odometry, to.odometry);
  const Pose2 measured = scaled(counted, scale);
  const Eigen::Vector3d sigma = to.odometry_noise * noise.sigmaOf(measured);
  const MotionFactor motion =
      loosened({measured, sigma.cwiseInverse().asDiagonal()},
               guessedOf({from.odometry, from.guessed}, {to.odometry, to.guessed}));
  const Factor<3, 2 * kPoseSize> of_poses = motion.at(from.pose, to.pose);
  const Eigen::Vector3d by_scale(-counted.x, -counted.y, 0.0);
  Factor<3, 2 * kPoseSize + 1> factor{of_poses.residual, {}, of_poses.weight};
  factor.jacobian << of_poses.jacobian, motion.root_information * by_scale;
  return factor;
}

}  // namespace handmap
