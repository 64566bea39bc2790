#include "core/estimation/walls/sensor_model.h"

#include <cmath>
#include <numbers>

#include "core/estimation/walls/constants.h"

namespace handmap {

using namespace walls;

namespace {

double normalDensity(double error, double sigma) {
  const double z = error / sigma;
  return std::exp(-0.5 * z * z) / (sigma * std::sqrt(2.0 * std::numbers::pi));
}

/// Of a normal distribution, nearer than z.
double shareBehind(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

}  // namespace

SensorModel::SensorModel(const SensorOptions& options, double range_limit_m)
    : options_(options),
      range_limit_m_(range_limit_m),
      blocked_(static_cast<float>(options.temper * std::log(options.clutter.at_walls))),
      passed_(static_cast<float>(options.temper * std::log(1.0 - options.hit))),
      silent_(static_cast<float>(options.temper * std::log(options.silent))) {
  const auto bins = static_cast<std::size_t>(range_limit_m / kDistanceStep_m) + 2;
  for (std::size_t i = 0; i < bins; ++i) {
    const double distance = (static_cast<double>(i) + 0.5) * kDistanceStep_m;
    const double sigma = options.noise.at(distance);
    returns_.push_back(
        {static_cast<float>(sigma * sigma), static_cast<float>(options.noise.bias(distance))});
  }
  table_.resize(kLevels * kLabels * kSteps);
  for (std::size_t level = 0; level < kLevels; ++level) {
    const double sigma = std::sqrt(middleOfQuarterOctave(kLeastLevel + static_cast<int>(level)));
    per_sigma_[level] = static_cast<float>(1.0 / sigma);
    for (int label = 0; label < kLabels; ++label) {
      mean_errors_[level * kLabels + static_cast<std::size_t>(label)] =
          static_cast<float>(meanError(label, sigma));
      for (std::size_t step = 0; step < kSteps; ++step) {
        const double z = zOf(step);
        const double ratio = 1.0 - options.hit * shareBehind(z) +
                             wallDensity(label, z * sigma, sigma) / otherDensity(options, label);
        table_[(level * kLabels + static_cast<std::size_t>(label)) * kSteps + step] =
            static_cast<float>(options.temper * std::log(ratio));
      }
    }
  }
}

int SensorModel::labelOf(double wall) {
  return static_cast<int>(std::lround(std::clamp(wall, 0.0, 1.0) * (kLabels - 1)));
}

double SensorModel::recognised(int label) const {
  const double wall = shareOf(label);
  return wall * options_.recognised + (1.0 - wall) * (1.0 - options_.recognised);
}

double SensorModel::wallDensity(int label, double error, double sigma) const {
  return options_.hit * recognised(label) * normalDensity(error, sigma);
}

double SensorModel::otherDensity(const SensorOptions& options, int label) {
  const double wall = shareOf(label);
  return wall * std::max(options.wall_like_per_m, options.clutter.wall_like_per_m) +
         (1.0 - wall) * std::max(options.others_per_m, options.clutter.others_per_m);
}

double SensorModel::responsibility(int label, double error, double sigma) const {
  const double wall = wallDensity(label, error, sigma);
  return wall / (wall + otherDensity(options_, label));
}

double SensorModel::meanError(int label, double sigma) const {
  const double wall = shareOf(label);
  const double rate =
      wall * options_.clutter.wall_like_per_m + (1.0 - wall) * options_.clutter.others_per_m;
  double weights = 0.0;
  double errors = 0.0;
  for (std::size_t step = 0; step < kSteps; ++step) {
    const double error = sigma * zOf(step);
    const double passed = 1.0 - options_.hit * shareBehind(zOf(step));
    const double weight =
        responsibility(label, error, sigma) * (wallDensity(label, error, sigma) + rate * passed);
    weights += weight;
    errors += weight * error;
  }
  return errors / weights;
}

float SensorModel::reach(float range) const {
  return static_cast<float>(kReach * options_.noise.at(range) +
                            std::abs(options_.noise.bias(range)));
}

}  // namespace handmap
