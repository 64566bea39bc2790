// What a residual is after it was linearised at the present states.
#pragma once

#include <Eigen/Core>

#include "core/estimation/smoothing/constants.h"

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

/// Of a pose, a box and the bias of the ranges, in this order: what a frame says of a building.
struct SightEquations {
  /// Where each begins, and how many there are.
  enum : int { kBox = smoothing::kPoseSize, kBias = kBox + smoothing::kBoxSize, kSize = kBias + 1 };

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
