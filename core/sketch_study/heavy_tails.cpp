#include "core/sketch_study/heavy_tails.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/pose2.h"

namespace handmap {

namespace {

constexpr double kFreedoms[] = {1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 15.0, 20.0, 30.0, 60.0};
constexpr int kRounds = 60;  // of expectation and maximization: the scale is then still to 1e-6

double scaleFor(const std::vector<double>& errors, double freedom, double first) {
  double square = first * first;
  for (int round = 0; round < kRounds; ++round) {
    double sum = 0.0;
    for (const double error : errors) {
      sum += (freedom + 1.0) * error * error / (freedom + error * error / square);
    }
    square = std::max(sum / static_cast<double>(errors.size()), 1e-300);
  }
  return std::sqrt(square);
}

}  // namespace

double normalLogDensity(double error, double sigma) {
  return -0.5 * (error * error / (sigma * sigma) + std::log(2.0 * kPi)) - std::log(sigma);
}

double HeavyTails::logDensity(double error) const {
  const double z = error / sigma;
  return std::lgamma((freedom + 1.0) / 2.0) - std::lgamma(freedom / 2.0) -
         0.5 * std::log(freedom * kPi) - std::log(sigma) -
         (freedom + 1.0) / 2.0 * std::log1p(z * z / freedom);
}

HeavyTails fitHeavyTails(const std::vector<double>& errors) {
  double square = 0.0;
  for (const double error : errors) square += error * error;
  const double rms = std::sqrt(std::max(square, 1e-300) / static_cast<double>(errors.size()));
  HeavyTails best;
  double most = -std::numeric_limits<double>::infinity();
  for (const double freedom : kFreedoms) {
    const HeavyTails tails{scaleFor(errors, freedom, rms), freedom};
    double likelihood = 0.0;
    for (const double error : errors) likelihood += tails.logDensity(error);
    if (likelihood <= most) continue;
    most = likelihood;
    best = tails;
  }
  return best;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::ranges::sort(values);
  const double at = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (at - std::floor(at)) * (values[above] - values[below]);
}

}  // namespace handmap
