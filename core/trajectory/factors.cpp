#include "core/trajectory/factors.h"

namespace handmap {

namespace {

/// How a point of the robot frame moves in the outer one when the robot turns.
Vec2 turned(const ToOuter& robot, const Vec2& point) { return perpendicular(robot.turned(point)); }

}  // namespace

LineFactor::Value LineFactor::at(const ToOuter& robot) const {
  const double distance = map.normal.dot(robot(point) - map.at);
  Eigen::RowVector3d slope;
  slope << map.normal.transpose(), map.normal.dot(turned(robot, point));
  return {distance / sigma_m, slope / sigma_m};
}

PointFactor::Value PointFactor::at(const ToOuter& robot) const {
  Eigen::Matrix<double, 2, 3> slope;
  slope << Eigen::Matrix2d::Identity(), turned(robot, point);
  return {(robot(point) - map) / sigma_m, slope / sigma_m};
}

}  // namespace handmap
