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

#include "core/tape/constants.h"
#include "core/tape/panning.h"
#include "core/tape/perceived.h"
#include "core/tape/tape_file.h"

namespace handmap {

struct SkippedFrame {
  int frame;
  std::string reason;
};

/// What only the newest observation still has.
struct Pictures {
  cv::Mat image;
  cv::Mat1f disparity;
  cv::Mat1f buildings;
  Panning panning;
};

/// What a tape may take of the newest, in bytes; on disk what no longer fits into memory.
struct TapeLimits {
  std::size_t memory = 0;
  std::size_t disk = 0;

  /// Where a run may be done again.
  static constexpr TapeLimits toDoAgain() { return {tape::kMemory, tape::kDisk}; }
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

  /// Keeps the newest: one at the least.
  Tape(std::unique_ptr<ObservationSource> source, const PerceptionOptions& options,
       const TapeLimits& limits);

  const SourceInfo& info() const { return info_; }

  /// The n-th of the run, from what is kept or from the source, which is asked for it if it is the
  /// next one. nullopt at the end of the source, and when `stop` was requested or it was closed;
  /// what was interrupted is there for who takes it next. Throws RunFailed where it is no longer
  /// kept. From any thread.
  std::optional<Taken> take(std::size_t n, const std::stop_token& stop);

  /// Lets go of the source, with all that it holds open: a drive, devices, files. What is kept
  /// stays. Interrupts what is perceived and waits for the source. From any thread; once is enough.
  void close();

  std::size_t end() const;     ///< so many were taken
  std::size_t begin() const;   ///< the first that is still kept
  std::size_t memory() const;  ///< bytes
  std::size_t disk() const;    ///< bytes
  /// nullptr: it was skipped, or is no longer kept. From any thread, as the next.
  std::shared_ptr<const Perceived> at(std::size_t n) const;
  /// Around the robot at the n-th, of what is kept of the way there.
  LocalMap localMap(std::size_t n) const;
  const LocalMapOptions& localMapOptions() const { return local_map_; }
  /// As recorded, of all that were taken; never forgotten.
  std::vector<StampedPose> odometry() const;

 private:
  struct Slot {
    Entry entry;            ///< its `perceived` is nullptr while it is on disk
    TapeFile::Place place;  ///< no bytes: it is not there
  };

  std::optional<Taken> perceive(const std::stop_token& stop);
  void keep(Entry entry);
  void moveToDisk();
  void dropBefore(std::size_t n);
  std::shared_ptr<const Perceived> perceivedAt(std::size_t n) const;

  const SourceInfo info_;
  const LocalMapOptions local_map_;
  const TapeLimits limits_;
  std::stop_source closing_;
  std::mutex source_mutex_;                    // one reads at a time; taken before mutex_
  std::unique_ptr<ObservationSource> source_;  // under source_mutex_; nullptr: closed
  std::optional<Observation> waiting_;         // under it: of the source, not yet perceived
  Perception perception_;

  mutable std::mutex mutex_;
  TapeFile file_;            // written under source_mutex_, all else of it under mutex_
  std::deque<Slot> slots_;   // under mutex_, as all below
  std::size_t first_ = 0;    ///< of slots_
  std::size_t on_disk_ = 0;  ///< that one and all after it are in memory; written as file_ is
  std::size_t memory_ = 0;   ///< bytes
  std::size_t disk_ = 0;     ///< bytes
  std::vector<StampedPose> odometry_;
};

}  // namespace handmap
