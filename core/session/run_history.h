// The past of a run, to be looked at: snapshots by the number of observations done.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>

#include "core/method/snapshot.h"

namespace handmap {

struct HistoryLimits {
  /// One in seven to fourteen seconds of an hour. Each has 20 to 100 kB of its own: the buildings
  /// of a map change with every key frame.
  std::size_t snapshots = 512;
  std::size_t picture_bytes = 128U << 20U;
};

/// Bounded: where there are too many, every other one of the past goes, and where the pictures need
/// too much, every other picture. From any thread.
class RunHistory {
 public:
  explicit RunHistory(const HistoryLimits& limits = {});

  /// Before anybody else has it. One of the same index takes the place of the one before.
  void add(const Snapshot& snapshot);

  /// Of another run over the same observations: what this one has no pictures of.
  void borrowPictures(const RunHistory& other);

  bool empty() const;
  int first() const;   ///< index
  int newest() const;  ///< index
  /// The newest that is no newer than `index`, else the first; nullptr of an empty one. Its
  /// pictures are those of `pictured`, which may be an earlier one. Reading it leaves the history
  /// as small as it is.
  std::shared_ptr<const Snapshot> at(int index) const;
  /// The index of the newest that was no later than `time_s`, else of the first.
  int indexAt(double time_s) const;

 private:
  void thinSnapshots();
  void thinPictures();

  HistoryLimits limits_;
  mutable std::mutex mutex_;
  std::map<int, Snapshot> past_;
  std::size_t picture_bytes_ = 0;
  int picture_step_ = 1;  ///< only of every so many-th snapshot the pictures are kept
  int step_ = 1;          ///< the same of the snapshots
};

}  // namespace handmap
