// The phases of one observation of our method, as they are told to those who want to look.
#pragma once

#include "core/method/estimation_method.h"

namespace handmap {

/// While the estimator takes one step.
class HandmapPhases {
 public:
  /// `method`: the one that the estimator works for. All of it must outlive this object.
  HandmapPhases(const HandmapEstimator& estimator, const Map& drawing, PhaseRecorder& recorder,
                const EstimationMethod& method);

  void operator()(EstimatorPhase phase);

 private:
  void tellWalls(Phase& phase) const;
  void tellLabels(Phase& phase) const;
  void tellCorrection(Phase& phase, const Map& before) const;

  const HandmapEstimator& estimator_;
  const Map& drawing_;
  PhaseRecorder& recorder_;
  const EstimationMethod& method_;
  Pose2 before_;  ///< the robot, after the phase before
  int loops_;
};

}  // namespace handmap
