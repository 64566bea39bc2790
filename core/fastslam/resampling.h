// Effective sample size and low-variance resampling (Thrun, Burgard, Fox, "Probabilistic
// Robotics", table 4.4; Liu 1996 for the size).
#pragma once

#include <vector>

namespace handmap {

/// Scales to a sum of 1; all equal when the sum is not positive.
void normalize(std::vector<double>& weights);

/// 1 / Σ w² of normalized weights: between 1 and their number.
double effectiveSampleSize(const std::vector<double>& weights);

/// As many indices as weights, each drawn in proportion to its normalized weight; `offset` in [0,
/// 1) is the one random number. Ascending.
std::vector<int> systematicResample(const std::vector<double>& weights, double offset);

}  // namespace handmap
