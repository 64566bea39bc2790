// Probabilities from the distances of a support vector machine.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace handmap {

/// p = 1 / (1 + exp(−slope·d − offset)).
struct Logistic {
  double slope = 1.0;
  double offset = 0.0;

  float operator()(float distance) const;

  /// The most likely one (Platt 1999; Lin, Lin and Weng 2007), where the classes weigh the same:
  /// the probability of a building if buildings and the rest were equally frequent, so that it may
  /// be multiplied with other evidence. Both classes are there.
  static Logistic fit(const Eigen::VectorXf& distances, const std::vector<bool>& positive);
};

}  // namespace handmap
