// How much the odometry turns by itself, estimated from how the smoothed way turns.
#pragma once

#include <deque>

#include "core/estimation/smoothing/constants.h"
#include "core/estimation/walls/frame.h"

namespace handmap {

/// Random turns of the odometry, collected over stretches of the way that the walls along it tell
/// better; a little is forgotten with each. (Of its lengths the way knows too little.)
class OdometryEstimate {
 public:
  /// `assumed`: variance of the heading after a metre, radians².
  explicit OdometryEstimate(double assumed) : turned_(smoothing::kAssumed_m * assumed) {}

  /// After each frame: takes the last stretch of the way that is smoothed well.
  void add(const std::deque<Frame>& frames);
  double headingVariance() const { return turned_ / driven_m_; }

 private:
  double turned_;  ///< sum of squares
  double driven_m_ = smoothing::kAssumed_m;
};

}  // namespace handmap
