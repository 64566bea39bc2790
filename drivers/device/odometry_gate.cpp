#include "drivers/device/odometry_gate.h"

#include <algorithm>

namespace handmap {

namespace {

/// Wheels slip, and the times of two poses may be nearly the same.
constexpr double kSlack_m = 0.3;
constexpr double kSlack_rad = 0.3;

}  // namespace

bool OdometryGate::reachable(const Told& from, double time_s, const Pose2& pose) const {
  const double passed_s = std::max(time_s - from.time_s, 0.0);
  const Pose2 motion = between(from.pose, pose);
  return motion.position().norm() <= limits_.speed * passed_s + kSlack_m &&
         std::abs(motion.heading) <= limits_.turn_rate * passed_s + kSlack_rad;
}

std::optional<Pose2> OdometryGate::pass(double time_s, const Pose2& pose) {
  if (last_ && !reachable(*last_, time_s, pose)) {
    if (!leap_ || !reachable(*leap_, time_s, pose)) {
      if (leap_) ++held_back_;
      leap_ = {time_s, pose};
      return std::nullopt;
    }
    ++restarts_;
    correction_ = correction_ * last_->pose * inverse(pose);
  } else if (leap_) {
    ++held_back_;
  }
  leap_.reset();
  last_ = {time_s, pose};
  return correction_ * pose;
}

}  // namespace handmap
