#include "core/fastslam/motion_model.h"

#include <Eigen/Eigenvalues>

namespace handmap {

Pose2 samplePose(const Pose2& pose, const Pose2& motion, const MotionNoise& noise,
                 RandomStream& random) {
  const double length = motion.position().norm();
  const double sigma_length = noise.min_length_m + noise.length_per_m * length;
  const double sigma_heading = noise.min_heading_rad + noise.heading_per_m * length +
                               noise.heading_per_rad * std::abs(motion.heading);
  const double stretch = length > 0.0 ? 1.0 + random.normal(0.0, sigma_length) / length : 1.0;
  const double turn_before = random.normal(0.0, sigma_heading / std::numbers::sqrt2);
  const double turn_after = random.normal(0.0, sigma_heading / std::numbers::sqrt2);
  const Pose2 disturbed{motion.x * stretch, motion.y * stretch, motion.heading + turn_after};
  return pose * Pose2{0.0, 0.0, turn_before} * disturbed;
}

Pose2 sampleGuess(const Pose2& motion, const Eigen::Matrix3d& variance, RandomStream& random) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(variance);
  const Eigen::Array3d sigma = axes.eigenvalues().array().max(0.0).sqrt();
  const Eigen::Array3d unit(random.normals<3>().data());
  const Eigen::Vector3d off = axes.eigenvectors() * (sigma * unit).matrix();
  return {motion.x + off.x(), motion.y + off.y(), normalizedAngle(motion.heading + off.z())};
}

}  // namespace handmap
