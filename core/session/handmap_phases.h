// The phases of one observation of our method, as they are told to those who want to look.
#pragma once

#include <functional>

#include "core/estimation/estimator.h"
#include "core/session/phase.h"

namespace handmap {

/// While the estimator takes one step.
class HandmapPhases {
 public:
  /// `describe`: what the method says of the robot at the time. All of it must outlive this object.
  HandmapPhases(const HandmapEstimator& estimator, const Map& drawing, PhaseRecorder& recorder,
                std::function<void(FrameReport&)> describe);

  void operator()(EstimatorPhase phase);

 private:
  void tellWalls(Phase& phase) const;
  void tellLabels(Phase& phase) const;
  void tellCorrection(Phase& phase, const Map& before) const;

  const HandmapEstimator& estimator_;
  const Map& drawing_;
  PhaseRecorder& recorder_;
  std::function<void(FrameReport&)> describe_;
  Pose2 before_;  ///< the robot, after the phase before
  int loops_;
};

}  // namespace handmap
