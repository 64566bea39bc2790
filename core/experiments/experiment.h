// An experiment: which trials it is made of, and their running.
#pragma once

#include <functional>
#include <map>
#include <stop_token>
#include <vector>

#include "core/experiments/trial.h"
#include "core/experiments/trial_folder.h"

namespace handmap {

/// The paper's Table II (success against σ) and Fig. 8 (errors of each building against σ), and
/// the errors over the way. All are views of the same trials. Table I is in timing.h.
enum class ExperimentKind { Table2, Figure8, Way };

struct Experiment {
  ExperimentKind kind = ExperimentKind::Table2;
  std::vector<double> sigmas_m;
  std::vector<Method> methods = {Method::Handmap, Method::Paper};
  int trials = 100;  ///< for each σ and method
  TrialSettings settings;
};

/// The σ that an experiment takes when none are given.
std::vector<double> usualSigmas(ExperimentKind kind);

/// All trials of the experiment, in order; each once.
std::vector<TrialKey> trialsOf(const Experiment& experiment);

/// Runs the shard's trials that are not in the folder yet, `threads` at a time (0: as many as the
/// machine has), and writes them in order: the table is the same on any number of threads.
/// `progress` is told after each the number done and that of all. Returns how many were run.
int runTrials(const Experiment& experiment, const Shard& shard, const std::filesystem::path& folder,
              int threads, const std::stop_token& stop,
              const std::function<void(int, int)>& progress = {});

}  // namespace handmap
