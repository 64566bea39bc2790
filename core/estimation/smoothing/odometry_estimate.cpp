#include "core/estimation/smoothing/odometry_estimate.h"

namespace handmap {

void OdometryEstimate::add(const std::deque<Frame>& frames) {
  constexpr std::size_t kStretch = 8;    // key frames; choice: 16 m
  constexpr std::size_t kUnsettled = 3;  // key frames; choice: the newest still move
  constexpr double kForgetting = 0.98;   // a key frame; choice: 100 m
  if (frames.size() <= kStretch + kUnsettled) return;
  const Frame& to = frames[frames.size() - 1 - kUnsettled];
  const Frame& from = frames[frames.size() - 1 - kUnsettled - kStretch];
  const double counted = between(from.odometry, to.odometry).heading;
  const double error = normalizedAngle(between(from.pose, to.pose).heading - counted);
  turned_ = kForgetting * turned_ + error * error;
  driven_m_ = kForgetting * driven_m_ + (to.driven_m - from.driven_m);
}

}  // namespace handmap
