// The folder in which trials gather: one table a shard, so that processes and machines that share
// nothing but the folder work on one experiment.
#pragma once

#include <filesystem>
#include <map>

#include "core/experiments/trial.h"

namespace handmap {

/// Each `count`-th trial, beginning with the `index`-th; 1 … count.
struct Shard {
  int index = 1;
  int count = 1;
};

/// The trials in all tables DIR/trials-*.csv, in their order. None where there is no folder. Throws
/// BadInput for other settings, a damaged table, or a trial that came out differently in two.
std::map<TrialKey, Trial> readTrials(const std::filesystem::path& folder,
                                     const TrialSettings& settings);

/// Appends to the table of a shard; every trial is on the disk's way before the next is taken.
class TrialWriter {
 public:
  /// Makes the folder and the table where there is none, and cuts off a line that an earlier
  /// process did not finish. Throws RunFailed where it cannot be written or another process does.
  TrialWriter(const std::filesystem::path& folder, const Shard& shard,
              const TrialSettings& settings);
  ~TrialWriter();
  TrialWriter(const TrialWriter&) = delete;
  TrialWriter& operator=(const TrialWriter&) = delete;

  void add(const Trial& trial);

 private:
  void append(const std::string& text);

  std::filesystem::path path_;
  int file_ = -1;
};

}  // namespace handmap
