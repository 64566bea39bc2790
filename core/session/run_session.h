// One run: a drawing, a source and settings in; snapshots, a refined map and a report out. The
// same for handmap-cli, the worker of the desktop program and the tests.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "core/method/run_settings.h"
#include "core/method/snapshot.h"
#include "core/session/run_warnings.h"
#include "core/tape/tape.h"

namespace handmap {

class RunSession {
 public:
  /// Throws BadInput for a map without buildings or without a start pose.
  RunSession(Map drawing, std::unique_ptr<ObservationSource> source, const RunSettings& settings);
  /// From its beginning, as far as the tape has it, then on; the tape was made with the perception
  /// of `settings`. With given poses the tape, or its source, must know the odometry up to the
  /// last.
  RunSession(Map drawing, std::shared_ptr<Tape> tape, const RunSettings& settings);
  ~RunSession();
  RunSession(const RunSession&) = delete;
  RunSession& operator=(const RunSession&) = delete;

  const SourceInfo& source() const;

  /// Takes the next observation that can be read and works it in. At the end of the source the
  /// method may smooth once more: one more snapshot. nullptr after that, and when `stop` was
  /// requested: the observation is then dropped and the state is the one before it. `progress` is
  /// told the share done of the step, 0 … 1, from this thread; it may wait there.
  std::shared_ptr<const Snapshot> step(const std::stop_token& stop = {},
                                       const std::function<void(double)>& progress = {});

  /// Snapshots of the steps that follow tell their phases; nothing else changes.
  void setTracing(bool on);

  const std::vector<SkippedFrame>& skipped() const;
  /// Of what was worked in so far: to be told at the end.
  std::vector<RunWarning> warnings() const;
  /// Of all that was worked in: 200 bytes each, 29 MB an hour of 40 a second.
  const std::vector<FrameReport>& frames() const;

  /// The best map with estimates and the "refinement" object: enough to make it again.
  Map refinedMap() const;
  std::vector<StampedPose> trajectory() const;
  /// FORMATS 3, --report.
  std::string reportJson() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace handmap
