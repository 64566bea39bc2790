// What a residual is after it was linearised at the present states.
#pragma once

#include <cmath>

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

/// Cauchy's kernel on a squared residual: cost k log(1 + s / k), and what s weighs in the normal
/// equations.
inline double cauchyCost(double square, double k) { return k * std::log1p(square / k); }
inline double cauchyWeight(double square, double k) { return 1.0 / (1.0 + square / k); }

}  // namespace handmap
