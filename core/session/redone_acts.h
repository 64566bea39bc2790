// A drive is gone over again: what a person said on it is said again.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/map/map.h"
#include "core/recording/trajectory.h"
#include "core/session/acts.h"

namespace handmap {

struct RedoneActs {
  Map drawing;                         ///< with what is right and without what is not there
  std::vector<StampedPose> poses;      ///< that were given, increasing in time
  std::vector<std::string> unmatched;  ///< buildings that the drawing does not have
};

/// One a moment: the last that was said of it. In order of time.
void give(std::vector<StampedPose>& poses, const StampedPose& pose);

/// On the drawing that the drive began with; on the one that it ended with nothing is new.
RedoneActs redone(const Map& drawing, std::span<const Act> acts);

}  // namespace handmap
