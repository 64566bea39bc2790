// What a residual is after it was linearised at the present states.
#pragma once

#include <Eigen/Core>

namespace handmap {

/// Several residuals of the same states. weight: 1/σ² of each, times what a robust kernel leaves.
template <int Rows, int Size>
struct Factor {
  Eigen::Matrix<double, Rows, 1> residual;
  Eigen::Matrix<double, Rows, Size> jacobian;
  Eigen::Matrix<double, Rows, 1> weight;
};

/// One residual.
template <int Size>
struct ScalarFactor {
  double residual = 0.0;
  Eigen::Matrix<double, Size, 1> slope = Eigen::Matrix<double, Size, 1>::Zero();
  double weight = 0.0;
};

/// Sizes of the states.
inline constexpr int kPoseSize = 3;  ///< x, y, heading
inline constexpr int kBoxSize = 5;   ///< Box::reach, heading
inline constexpr int kLandmarkSize = 2;
inline constexpr int kMotionSize = 4;  ///< DrawingMotion::mean

/// How many times as far as a wall the end of one, or the middle of a thing, is off systematically.
/// Choice: eaves, gutters and branches.
inline constexpr double kEndsAreWorse = 3.0;

/// Of a pose, a box and the bias of the ranges, in this order: what a frame says of a building.
struct SightEquations {
  static constexpr int kSize = kPoseSize + kBoxSize + 1;
  static constexpr int kBox = kPoseSize;
  static constexpr int kBias = kPoseSize + kBoxSize;

  Eigen::Matrix<double, kSize, kSize> matrix = Eigen::Matrix<double, kSize, kSize>::Zero();
  Eigen::Matrix<double, kSize, 1> right = Eigen::Matrix<double, kSize, 1>::Zero();

  void add(const ScalarFactor<kSize>& factor) {
    matrix.noalias() += factor.weight * factor.slope * factor.slope.transpose();
    right.noalias() -= factor.weight * factor.residual * factor.slope;
  }
  void add(const SightEquations& other, double share) {
    matrix += share * other.matrix;
    right += share * other.right;
  }
};

}  // namespace handmap
