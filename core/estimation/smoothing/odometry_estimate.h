// How much the odometry turns by itself, estimated from how the smoothed way turns.
#pragma once

#include <algorithm>
#include <deque>

#include "core/estimation/smoothing/constants.h"
#include "core/estimation/walls/frame.h"

namespace handmap {

/// Random turns of the odometry, collected over stretches of the way that the walls along it tell
/// better; a little is forgotten with each. (Of its lengths the way knows too little.) At most what
/// is assumed: beyond it the smoothed way turns by its own errors as well.
class OdometryEstimate {
 public:
  /// `assumed`: variance of the heading after a metre, radians².
  explicit OdometryEstimate(double assumed)
      : assumed_(assumed), turned_(smoothing::kAssumed_m * assumed) {}

  /// After each frame: takes the last stretch of the way that is smoothed well.
  void add(const std::deque<Frame>& frames);
  double headingVariance() const { return std::min(turned_ / driven_m_, assumed_); }

 private:
  double assumed_;
  double turned_;  ///< sum of squares
  double driven_m_ = smoothing::kAssumed_m;
};

}  // namespace handmap
