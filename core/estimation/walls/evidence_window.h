// The evidence of the last frames, as the robot goes.
#pragma once

#include <stop_token>

#include "core/estimation/walls/wall_evidence.h"

namespace handmap {

class EvidenceWindow {
 public:
  /// Holds at most `most` frames, none farther than `reach_m` from the last; `window_m` as for
  /// WallEvidence.
  EvidenceWindow(double cell_m, double window_m, double reach_m, std::size_t most,
                 const SensorModel& sensor)
      : evidence_(cell_m, window_m), reach_m_(reach_m), most_(most) {
    setSensor(sensor);
  }

  /// Takes up a frame, which stays where it is, gives up those that are too far or too many, and
  /// puts in anew some of those that have moved or that another model weighed, the newest first.
  void add(Frame& frame);
  /// Puts in all frames where they are now; when `stop` was requested that is left to add().
  void reinsertAll(const std::stop_token& stop = {});
  /// The frames are weighed by it as they are put in.
  void setSensor(const SensorModel& sensor) {
    sensor_ = std::make_shared<const SensorModel>(sensor);
  }

  std::span<const ActiveFrame> frames() const { return frames_; }
  WallEvidence& evidence() { return evidence_; }

 private:
  bool isOutdated(const ActiveFrame& active) const;

  WallEvidence evidence_;
  std::shared_ptr<const SensorModel> sensor_;
  double reach_m_;
  std::size_t most_;
  std::vector<ActiveFrame> frames_;
};

}  // namespace handmap
