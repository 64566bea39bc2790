#include "core/estimation/smoothing/odometry_estimate.h"

#include "core/estimation/smoothing/constants.h"

namespace handmap {

using namespace smoothing;

void OdometryEstimate::add(const std::deque<Frame>& frames) {
  if (frames.size() <= kStretch + kUnsettled) return;
  const Frame& to = frames[frames.size() - 1 - kUnsettled];
  const Frame& from = frames[frames.size() - 1 - kUnsettled - kStretch];
  const double counted = between(from.odometry, to.odometry).heading;
  const double error = normalizedAngle(between(from.pose, to.pose).heading - counted);
  turned_ = kForgetting * turned_ + error * error;
  driven_m_ = kForgetting * driven_m_ + (to.driven_m - from.driven_m);
}

}  // namespace handmap
