#include "core/pose_graph/motion_factor.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace handmap {

Factor<3, 6> MotionFactor::at(const Pose2& from, const Pose2& to) const {
  const double c = std::cos(from.heading);
  const double s = std::sin(from.heading);
  const Vec2 own = from.toOwn(to.position());
  Factor<3, 6> factor;
  factor.residual << own - motion.position(),
      normalizedAngle(to.heading - from.heading - motion.heading);
  factor.jacobian << -c, -s, own.y(), c, s, 0.0,  //
      s, -c, -own.x(), -s, c, 0.0,                //
      0.0, 0.0, -1.0, 0.0, 0.0, 1.0;
  factor.residual = root_information * factor.residual;
  factor.jacobian = root_information * factor.jacobian;
  factor.weight.setOnes();
  return factor;
}

MotionFactor loosened(const MotionFactor& motion, const Eigen::Matrix3d& variance) {
  if (variance.isZero()) return motion;
  const Eigen::Matrix3d known = motion.root_information.transpose() * motion.root_information;
  const auto root = rootOf((known.inverse() + variance).inverse());
  return {motion.motion, root.value_or(motion.root_information)};
}

std::optional<Eigen::Matrix3d> rootOf(const Eigen::Matrix3d& information) {
  const Eigen::LLT<Eigen::Matrix3d> root(information);
  if (root.info() != Eigen::Success || !information.allFinite()) return std::nullopt;
  return Eigen::Matrix3d(root.matrixU());
}

Pose2 stepped(const Pose2& pose, const Eigen::Vector3d& step) {
  return {pose.x + step.x(), pose.y + step.y(), normalizedAngle(pose.heading + step.z())};
}

}  // namespace handmap
