#include "core/trajectory/factors.h"

namespace handmap {

namespace {

/// How a point of the robot frame moves in the outer one when the robot turns.
Vec2 turned(const Pose2& pose, const Vec2& point) {
  return perpendicular(pose.toOuter(point) - pose.position());
}

}  // namespace

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

}  // namespace handmap
