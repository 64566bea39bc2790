#include "core/estimation/odometry_estimate.h"

namespace handmap {

void OdometryEstimate::add(const std::deque<Frame>& frames) {
  constexpr std::size_t kStretch = 8;  // frames
  constexpr std::size_t kUnsettled = 3;
  constexpr double kForgetting = 0.98;
  if (frames.size() <= kStretch + kUnsettled) return;
  const Frame& to = frames[frames.size() - 1 - kUnsettled];
  const Frame& from = frames[frames.size() - 1 - kUnsettled - kStretch];
  const double counted = between(from.odometry, to.odometry).heading;
  const double error = normalizedAngle(between(from.pose, to.pose).heading - counted);
  turned_ = kForgetting * turned_ + error * error;
  way_m_ = kForgetting * way_m_ + (to.way_m - from.way_m);
}

}  // namespace handmap
