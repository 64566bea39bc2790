// The phases of one observation of the published method (Algorithm 1), as they are told to those
// who want to look.
#pragma once

#include "core/fastslam/fastslam_psom.h"
#include "core/method/phase.h"
#include "core/perception/local_map.h"

namespace handmap {

/// After a step.
struct PaperStep {
  const FastSlamPsom& slam;
  const Map& drawing;
  const LazyLocalMap& local_map;
  Pose2 before;  ///< of the best particle
};

void tellPhases(const SlamTrace& trace, const PaperStep& step, PhaseRecorder& recorder);

}  // namespace handmap
