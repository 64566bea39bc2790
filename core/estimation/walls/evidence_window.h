// The evidence of the last frames, as the robot goes.
#pragma once

#include <stop_token>

#include "core/estimation/walls/wall_evidence.h"

namespace handmap {

class EvidenceWindow {
 public:
  /// Holds at most `most` frames, none farther than `reach_m` from the last; `window_m` as for
  /// WallEvidence.
  EvidenceWindow(double cell_m, double window_m, double reach_m, std::size_t most)
      : evidence_(cell_m, window_m), reach_m_(reach_m), most_(most) {}

  /// Takes up a frame, which stays where it is, gives up those that are too far or too many, and
  /// puts in anew some of those that have moved most lately.
  void add(Frame& frame, const SensorModel& sensor);
  /// Puts in all frames where they are now; when `stop` was requested that is left to add().
  void reinsertAll(const SensorModel& sensor, const std::stop_token& stop = {});
  /// After what they saw was changed.
  void weighAnew(const SensorModel& sensor) { evidence_.putAnew(frames_, sensor); }
  /// Weighs all with another model, which takes the place of `sensor`.
  void changeSensor(SensorModel& sensor, const SensorOptions& options);

  std::span<const ActiveFrame> frames() const { return frames_; }
  WallEvidence& evidence() { return evidence_; }

 private:
  void reinsert(ActiveFrame& active, const SensorModel& sensor);

  WallEvidence evidence_;
  double reach_m_;
  std::size_t most_;
  std::vector<ActiveFrame> frames_;
};

}  // namespace handmap
