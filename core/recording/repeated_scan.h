// A scanner that sends the same scan again and again is told by what no real one does: it measures
// the same to the last bit from two places.
#pragma once

#include <algorithm>
#include <vector>

#include "core/recording/observation.h"

namespace handmap {

/// The same, and enough of it that no sensor measures it twice while it moves.
inline bool isRepeated(const std::vector<RangePoint>& before,
                       const std::vector<RangePoint>& after) {
  constexpr auto kTelling = 20;
  const auto is_same = [](const RangePoint& a, const RangePoint& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
  };
  return std::equal(before.begin(), before.end(), after.begin(), after.end(), is_same) &&
         std::count_if(after.begin(), after.end(), isMeasured) >= kTelling;
}

/// Since the sensor has moved so, what it sees is no longer the same.
inline bool isElsewhere(const Pose2& motion) {
  constexpr double kMoved_m = 0.1;
  return motion.position().norm() > kMoved_m ||
         std::abs(normalizedAngle(motion.heading)) > toRadians(1.0);
}

}  // namespace handmap
