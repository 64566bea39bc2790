// Loop closure: buildings that are found again after a long time tell how far the trajectory has
// drifted.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/estimation/loops/same_building.h"

namespace handmap {

/// How far the trajectory may have drifted since the old boxes were seen, about `here`; one σ.
struct DriftPrior {
  Vec2 here = Vec2::Zero();  ///< map frame
  double shift_m = 1.0;
  double turn = 0.03;  ///< radians
};

/// Which of the pairs that the labels tell are right, if the boxes agree with each other; nullopt
/// where that is not sure. One building alone may be any: there are at least two.
std::optional<std::vector<SameBuilding>> closeLoop(std::span<const FoundBox> boxes,
                                                   std::span<const SameBuilding> candidates,
                                                   const DriftPrior& prior);

}  // namespace handmap
