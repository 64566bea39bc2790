#include "core/trajectory/factors.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace handmap {

namespace {

/// How a point of the robot frame moves in the outer one when the robot turns.
Vec2 turned(const Pose2& pose, const Vec2& point) {
  return perpendicular(pose.toOuter(point) - pose.position());
}

}  // namespace

MotionFactor::Value MotionFactor::at(const Pose2& from, const Pose2& to) const {
  const double c = std::cos(from.heading);
  const double s = std::sin(from.heading);
  Eigen::Matrix2d to_own;
  to_own << c, s, -s, c;
  const Vec2 own = from.toOwn(to.position());
  Eigen::Vector3d residual;
  residual << own - motion.position(), normalizedAngle(to.heading - from.heading - motion.heading);
  Eigen::Matrix3d from_slope = Eigen::Matrix3d::Zero();
  from_slope.topLeftCorner<2, 2>() = -to_own;
  from_slope.topRightCorner<2, 1>() = -perpendicular(own);
  from_slope(2, 2) = -1.0;
  Eigen::Matrix3d to_slope = Eigen::Matrix3d::Zero();
  to_slope.topLeftCorner<2, 2>() = to_own;
  to_slope(2, 2) = 1.0;
  return {root_information * residual, root_information * from_slope, root_information * to_slope};
}

LineFactor::Value LineFactor::at(const Pose2& pose) const {
  const double distance = map.normal.dot(pose.toOuter(point) - map.at);
  Eigen::RowVector3d slope;
  slope << map.normal.transpose(), map.normal.dot(turned(pose, point));
  return {distance / sigma_m, slope / sigma_m};
}

PointFactor::Value PointFactor::at(const Pose2& pose) const {
  Eigen::Matrix<double, 2, 3> slope;
  slope << Eigen::Matrix2d::Identity(), turned(pose, point);
  return {(pose.toOuter(point) - map) / sigma_m, slope / sigma_m};
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

double cauchyCost(double square, double k) { return k * std::log1p(square / k); }

Pose2 stepped(const Pose2& pose, const Eigen::Vector3d& step) {
  return {pose.x + step.x(), pose.y + step.y(), normalizedAngle(pose.heading + step.z())};
}

}  // namespace handmap
