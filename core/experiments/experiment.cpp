#include "core/experiments/experiment.h"

#include <algorithm>

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

namespace handmap {

namespace {

std::vector<TrialKey> missingTrials(const Experiment& experiment, const Shard& shard,
                                    const std::filesystem::path& folder) {
  const auto there = readTrials(folder, experiment.settings);
  const std::vector<TrialKey> all = trialsOf(experiment);
  std::vector<TrialKey> missing;
  for (auto i = static_cast<std::size_t>(shard.index - 1); i < all.size();
       i += static_cast<std::size_t>(shard.count)) {
    if (!there.contains(all[i])) missing.push_back(all[i]);
  }
  return missing;
}

}  // namespace

std::vector<double> usualSigmas(ExperimentKind kind) {
  if (kind == ExperimentKind::Way) return {5.0};
  return {1.0, 5.0, 10.0, 12.5, 15.0};
}

std::vector<TrialKey> trialsOf(const Experiment& experiment) {
  std::vector<TrialKey> keys;
  for (const Method method : experiment.methods) {
    for (const double sigma_m : experiment.sigmas_m) {
      for (int number = 0; number < experiment.trials; ++number) {
        keys.push_back({method, sigma_m, number});
      }
    }
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

int runTrials(const Experiment& experiment, const Shard& shard, const std::filesystem::path& folder,
              int threads, const std::stop_token& stop,
              const std::function<void(int, int)>& progress) {
  const std::vector<TrialKey> missing = missingTrials(experiment, shard, folder);
  if (missing.empty()) return 0;
  TrialWriter writer(folder, shard, experiment.settings);
  std::size_t next = 0;
  int done = 0;
  const auto take = [&](tbb::flow_control& control) {
    if (next == missing.size() || stop.stop_requested()) control.stop();
    return next++;
  };
  const auto run = [&](std::size_t i) { return runTrial(missing[i], experiment.settings, stop); };
  const auto write = [&](const std::optional<Trial>& trial) {
    if (!trial) return;
    writer.add(*trial);
    ++done;
    if (progress) progress(done, static_cast<int>(missing.size()));
  };
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute([&] {
    const auto at_once = static_cast<std::size_t>(arena.max_concurrency());
    tbb::parallel_pipeline(
        2 * at_once,  // one that is done waits for its turn while the next one runs
        tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, take) &
            tbb::make_filter<std::size_t, std::optional<Trial>>(tbb::filter_mode::parallel, run) &
            tbb::make_filter<std::optional<Trial>, void>(tbb::filter_mode::serial_in_order, write));
  });
  return done;
}

}  // namespace handmap
