// What a robot has perceived, kept in memory: nothing of it depends on the drawing, so that a run
// is done again with another drawing without looking at one image twice.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/perception/perception.h"
#include "core/recording/observation.h"
#include "core/session/snapshot.h"

namespace handmap {

struct SkippedFrame {
  int frame;
  std::string reason;
};

/// An observation as a method takes it.
struct Perceived {
  Observation observation;  ///< without its views
  Percept percept;          ///< without its pictures; its local map is for again()
};

/// What only the newest observation still has.
struct Pictures {
  cv::Mat image;
  cv::Mat1f disparity;
  cv::Mat1f buildings;
  Panning panning;
};

class Tape {
 public:
  struct Entry {
    std::shared_ptr<const Perceived> perceived;  ///< nullptr: it was skipped
    std::optional<SkippedFrame> skipped;
  };
  struct Taken {
    Entry entry;
    Pictures pictures;      ///< where it was perceived now
    bool from_now = false;  ///< it was
  };

  /// Keeps so many bytes at most, the newest.
  Tape(std::unique_ptr<ObservationSource> source, const PerceptionOptions& options,
       std::size_t most_bytes);

  const SourceInfo& info() const { return info_; }

  /// The n-th of the run, from memory or from the source, which is asked for it if it is the next
  /// one. nullopt at the end of the source, and when `stop` was requested or it was closed; what
  /// was interrupted is there for who takes it next. Throws RunFailed where it is no longer in
  /// memory. From any thread.
  std::optional<Taken> take(std::size_t n, const std::stop_token& stop);

  /// Lets go of the source, with all that it holds open: a drive, devices, files. What is in memory
  /// stays. Interrupts what is perceived and waits for the source. From any thread; once is enough.
  void close();

  std::size_t end() const;    ///< so many were taken
  std::size_t begin() const;  ///< the first that is still in memory
  /// Everything in memory; skipped ones are left out.
  std::vector<std::shared_ptr<const Perceived>> all() const;
  /// As recorded, of all that were taken; never forgotten.
  std::vector<StampedPose> odometry() const;

 private:
  std::optional<Taken> perceive(const std::stop_token& stop);
  void keep(Entry entry);

  const SourceInfo info_;
  std::stop_source closing_;
  std::mutex source_mutex_;                    // one reads at a time; taken before mutex_
  std::unique_ptr<ObservationSource> source_;  // under source_mutex_; nullptr: closed
  std::optional<Observation> waiting_;         // under it: of the source, not yet perceived
  Perception perception_;

  mutable std::mutex mutex_;
  std::deque<Entry> entries_;  // under mutex_, as all below
  std::size_t first_ = 0;      ///< of entries_
  std::size_t bytes_ = 0;
  std::size_t most_bytes_;
  std::vector<StampedPose> odometry_;
};

}  // namespace handmap
