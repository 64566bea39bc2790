// The evaluations that keep no trials: times and reliability.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/experiments/experiment.h"
#include "core/experiments/report.h"
#include "core/recording/recording.h"

namespace handmap {

/// A recording with truth, a drawing of the place and its true map.
struct RealRun {
  std::string recording;
  std::string map;
  std::string truth;
  ReplayOptions replay;
};

// nullopt: interrupted. Trials 0: as many as usual. They show their progress.
std::optional<Report> evaluateTimes(std::uint64_t seed, int trials, int threads);
std::optional<Report> evaluateReliability(const Experiment& experiment, int trials,
                                          const std::vector<RealRun>& real);

}  // namespace handmap
