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

SensorModel::SensorModel(const MeasuredSensor& measured, double range_limit_m)
    : measured_(measured),
      range_limit_m_(range_limit_m),
      blocked_(static_cast<float>(kTemper * std::log(measured.clutter.at_walls))),
      passed_(static_cast<float>(kTemper * std::log(1.0 - kHit))),
      silent_(static_cast<float>(kTemper * std::log(kSilence))) {
  const auto bins = static_cast<std::size_t>(range_limit_m / kDistanceStep_m) + 2;
  for (std::size_t i = 0; i < bins; ++i) {
    const double distance = (static_cast<double>(i) + 0.5) * kDistanceStep_m;
    const double sigma = measured.noise.at(distance);
    returns_.push_back(
        {static_cast<float>(sigma * sigma), static_cast<float>(measured.noise.bias(distance))});
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
        const double ratio = 1.0 - kHit * shareBehind(z) +
                             wallDensity(label, z * sigma, sigma) / otherDensity(label);
        table_[(level * kLabels + static_cast<std::size_t>(label)) * kSteps + step] =
            static_cast<float>(kTemper * std::log(ratio));
      }
    }
  }
}

int SensorModel::labelOf(double wall) {
  return static_cast<int>(std::lround(std::clamp(wall, 0.0, 1.0) * (kLabels - 1)));
}

double SensorModel::recognised(int label) const {
  const double wall = shareOf(label);
  return wall * kRecognised + (1.0 - wall) * (1.0 - kRecognised);
}

double SensorModel::wallDensity(int label, double error, double sigma) const {
  return kHit * recognised(label) * normalDensity(error, sigma);
}

double SensorModel::otherDensity(int label) const {
  const double wall = shareOf(label);
  return wall * std::max(kWallLike, measured_.clutter.wall_like_per_m) +
         (1.0 - wall) * std::max(kOthers, measured_.clutter.others_per_m);
}

double SensorModel::responsibility(int label, double error, double sigma) const {
  const double wall = wallDensity(label, error, sigma);
  return wall / (wall + otherDensity(label));
}

double SensorModel::meanError(int label, double sigma) const {
  const double wall = shareOf(label);
  const double rate =
      wall * measured_.clutter.wall_like_per_m + (1.0 - wall) * measured_.clutter.others_per_m;
  double weights = 0.0;
  double errors = 0.0;
  for (std::size_t step = 0; step < kSteps; ++step) {
    const double error = sigma * zOf(step);
    const double passed = 1.0 - kHit * shareBehind(zOf(step));
    const double weight =
        responsibility(label, error, sigma) * (wallDensity(label, error, sigma) + rate * passed);
    weights += weight;
    errors += weight * error;
  }
  return errors / weights;
}

float SensorModel::reach(float range) const {
  return static_cast<float>(kReach * measured_.noise.at(range) +
                            std::abs(measured_.noise.bias(range)));
}

}  // namespace handmap
