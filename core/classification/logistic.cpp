#include "core/classification/logistic.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace handmap {

namespace {

constexpr int kIterations = 50;
constexpr double kNewtonRidge = 1e-6;  // a finite step where the classes do not overlap

}  // namespace

float Logistic::operator()(float distance) const {
  return static_cast<float>(1.0 /
                            (1.0 + std::exp(-slope * static_cast<double>(distance) - offset)));
}

Logistic Logistic::fit(const Eigen::VectorXf& distances, const std::vector<bool>& positive) {
  const auto all = static_cast<double>(positive.size());
  const auto positives = static_cast<double>(std::count(positive.begin(), positive.end(), true));
  // Platt's targets: one more of each class has been seen than has.
  const double high = (positives + 1.0) / (positives + 2.0);
  const double low = 1.0 / (all - positives + 2.0);
  Eigen::Vector2d line(1.0, 0.0);
  for (int i = 0; i < kIterations; ++i) {
    Eigen::Vector2d gradient = -kNewtonRidge * line;
    Eigen::Matrix2d curvature = kNewtonRidge * Eigen::Matrix2d::Identity();
    for (Eigen::Index k = 0; k < distances.size(); ++k) {
      const bool is_positive = positive[static_cast<std::size_t>(k)];
      const double weight = 0.5 / (is_positive ? positives : all - positives);
      const Eigen::Vector2d input(static_cast<double>(distances[k]), 1.0);
      const double p = 1.0 / (1.0 + std::exp(-input.dot(line)));
      gradient += weight * ((is_positive ? high : low) - p) * input;
      curvature += weight * std::max(p * (1.0 - p), 1e-9) * input * input.transpose();
    }
    Eigen::Vector2d step = curvature.inverse() * gradient;
    step *= std::min(1.0, 2.0 / std::max(step.norm(), 1e-12));
    line += step;
    if (step.norm() < 1e-9) break;
  }
  return {line[0], line[1]};
}

}  // namespace handmap
