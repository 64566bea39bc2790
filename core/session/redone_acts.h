// A drive is gone over again: what a person said on it is said again.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/map/map.h"
#include "core/recording/acts.h"
#include "core/recording/trajectory.h"

namespace handmap {

struct RedoneActs {
  Map drawing;                         ///< with what is right and without what is not there
  std::vector<StampedPose> poses;      ///< that were given, increasing in time
  std::vector<std::string> unmatched;  ///< buildings that the drawing does not have
};

/// On the drawing that the drive began with; on the one that it ended with nothing is new.
RedoneActs redone(const Map& drawing, std::span<const Act> acts);

}  // namespace handmap
