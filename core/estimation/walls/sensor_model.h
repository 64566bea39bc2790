// What a ray says about a wall that it would meet: a log likelihood ratio, tabulated.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/base/quarter_octave.h"
#include "core/estimation/walls/constants.h"
#include "core/perception/range_noise.h"

namespace handmap {

/// Returns from things in front of walls.
struct Clutter {
  double wall_like_per_m = 0.0;  ///< density along a ray that comes so far
  double others_per_m = 0.0;
  /// How much more often a ray ends early that goes to a wall than one that passes beside it: 1
  /// where things simply stand there, more where what is seen of walls is often false.
  double at_walls = 1.0;
};

struct MeasuredSensor {
  RangeNoise noise;
  Clutter clutter;
};

/// A ray as the model reads it. `label` and `range` are those of a return; where nothing came back
/// `label` is walls::kSilent and `range` is how far was looked through.
struct Sight {
  float range = 0.0F;
  int label = 0;
};

/// log p(return | wall at d) − log p(return | no wall), normalised over the returns. Things in
/// front of d hide the wall and say nothing; a return from behind d, or none, speaks against it.
class SensorModel {
 public:
  SensorModel(const MeasuredSensor& measured, double range_limit_m);

  static int labelOf(double wall);
  static double shareOf(int label) { return static_cast<double>(label) / (walls::kLabels - 1); }

  /// `slack_m`: how far, along the ray, the wall may be off for other reasons than range noise.
  float operator()(const Sight& sight, float distance, float slack_m) const {
    if (sight.label == walls::kSilent) return distance < sight.range ? silent_ : 0.0F;
    const Return expected = returnFrom(distance);
    const std::size_t level = levelOf(expected.variance + slack_m * slack_m);
    const float z = (sight.range - distance - expected.bias) * per_sigma_[level];
    if (z <= -walls::kReach) return 0.0F;
    if (z >= walls::kReach) return passed_;
    const auto step = static_cast<std::size_t>((z + walls::kReach) * walls::kStepsPerSigma);
    return table_[(level * walls::kLabels + static_cast<std::size_t>(sight.label)) * walls::kSteps +
                  step];
  }
  /// Responsibility of the wall for a return `error` metres off, 0 … 1: the weight of the return in
  /// a robust fit.
  double responsibility(int label, double error, double sigma) const;
  /// What returns around a wall are off in the mean, weighed by their responsibilities: less than
  /// 0, for things stand in front of walls and not behind.
  double clutterError(int label, double sigma) const {
    const std::size_t level = levelOf(static_cast<float>(sigma * sigma));
    return static_cast<double>(
        mean_errors_[level * walls::kLabels + static_cast<std::size_t>(label)]);
  }

  /// Whether it is a return from something clearly in front of a wall at this distance.
  bool isBefore(const Sight& sight, float distance, float slack_m) const {
    return sight.label != walls::kSilent &&
           sight.range < distance - reach(distance) - walls::kReach * slack_m;
  }
  /// log p(return from in front | wall) − log p(the same | no wall).
  float blocked() const { return blocked_; }
  float passed() const { return passed_; }
  float silent() const { return silent_; }
  double rangeLimit() const { return range_limit_m_; }
  const MeasuredSensor& measured() const { return measured_; }
  /// How far around a return its table reaches, metres.
  float reach(float range) const;

 private:
  struct Return {
    float variance;
    float bias;
  };
  Return returnFrom(float distance) const {
    const auto bin = static_cast<std::size_t>(distance * (1.0F / walls::kDistanceStep_m));
    return returns_[std::min(bin, returns_.size() - 1)];
  }
  static std::size_t levelOf(float variance) {
    const int level = quarterOctave(variance) - walls::kLeastLevel;
    return static_cast<std::size_t>(std::clamp(level, 0, static_cast<int>(walls::kLevels) - 1));
  }
  static double zOf(std::size_t step) {
    return (static_cast<double>(step) + 0.5) / walls::kStepsPerSigma - walls::kReach;
  }
  double meanError(int label, double sigma) const;
  double recognised(int label) const;
  double wallDensity(int label, double error, double sigma) const;
  double otherDensity(int label) const;

  MeasuredSensor measured_;
  double range_limit_m_;
  float blocked_;
  float passed_;
  float silent_;
  std::vector<Return> returns_;  ///< by distance
  std::array<float, walls::kLevels> per_sigma_{};
  std::array<float, walls::kLevels * walls::kLabels> mean_errors_{};
  std::vector<float> table_;
};

}  // namespace handmap
