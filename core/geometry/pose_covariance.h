// Covariances of poses: (x, y, heading), metres and radians.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/geometry/pose2.h"

namespace handmap {

/// From one frame to another, in which its x axis has this heading.
inline Eigen::Matrix3d turnedBy(double heading_rad, const Eigen::Matrix3d& covariance) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(heading_rad).toRotationMatrix();
  return turn * covariance * turn.transpose();
}

/// Of what goes on from an uncertain pose by `lever`: its heading swings the end of it.
inline Eigen::Matrix3d swungBy(const Vec2& lever, const Eigen::Matrix3d& covariance) {
  Eigen::Matrix3d slope = Eigen::Matrix3d::Identity();
  slope.topRightCorner<2, 1>() = perpendicular(lever);
  return slope * covariance * slope.transpose();
}

}  // namespace handmap
