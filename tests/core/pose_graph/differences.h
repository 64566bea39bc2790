// Slopes by differences, to check those that were derived.
#pragma once

#include "core/pose_graph/motion_factor.h"

namespace handmap::test {

inline constexpr double kStep = 1e-6;

/// Of a function of a pose.
template <int Rows, typename Function>
Eigen::Matrix<double, Rows, 3> differences(const Function& residual, const Pose2& pose) {
  Eigen::Matrix<double, Rows, 3> slope;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
    slope.col(i) = (residual(stepped(pose, step)) - residual(stepped(pose, -step))) / (2 * kStep);
  }
  return slope;
}

}  // namespace handmap::test
