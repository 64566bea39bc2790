// Trials made up for tests, without a run.
#pragma once

#include "core/experiments/trial.h"

namespace handmap::test {

/// Every building is drawn off by σ and found off by a tenth of that, with this IoU.
inline Trial madeTrial(const TrialKey& key, double iou, std::size_t steps = 3) {
  Trial trial;
  trial.key = key;
  const double off = key.sigma_m;
  for (TrialBuilding& building : trial.buildings) {
    building = {{off, -2.0 * off, 3.0 * off}, {off / 10.0, 0.2 * off, -0.3 * off}, iou, iou > 0.0};
  }
  for (std::size_t i = 0; i < steps; ++i) {
    const auto step = static_cast<double>(i);
    trial.way.push_back({0.1 * step, 0.5 * step, off - 0.25 * step});
  }
  return trial;
}

}  // namespace handmap::test
