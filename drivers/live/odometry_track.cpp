#include "drivers/live/odometry_track.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace handmap {

namespace {

constexpr double kKept_s = 60.0;
constexpr std::size_t kMostPoses = 20'000;  // 300 Hz
constexpr double kLongestGap_s = 1.5;       // of one a second, of which one comes late
// What encoders and gyroscopes of a standing robot tremble by.
constexpr double kStill_m = 0.02;
constexpr double kStill_rad = 0.02;

bool still(const Pose2& a, const Pose2& b) {
  return (a.position() - b.position()).norm() <= kStill_m &&
         std::abs(normalizedAngle(a.heading - b.heading)) <= kStill_rad;
}

}  // namespace

bool OdometryTrack::add(double time_s, const Pose2& pose) {
  if (!poses_.empty() && time_s <= poses_.back().time_s) return false;
  const bool gap = poses_.empty() || time_s - poses_.back().time_s > kLongestGap_s;
  poses_.push_back({time_s, pose});
  newest_ = poses_.back();
  if (gap || !stood_at_ || !still(stood_at_->pose, pose)) stood_at_ = poses_.back();
  while (poses_.size() > kMostPoses || poses_.front().time_s < time_s - kKept_s) {
    poses_.pop_front();
  }
  return true;
}

std::optional<Pose2> OdometryTrack::at(double time_s) const {
  const auto after = std::lower_bound(
      poses_.begin(), poses_.end(), time_s,
      [](const StampedPose& stamped, double time) { return stamped.time_s < time; });
  if (after == poses_.end()) return std::nullopt;
  if (after->time_s == time_s) return after->pose;
  if (after == poses_.begin()) return std::nullopt;
  const StampedPose& before = *std::prev(after);
  const double gap = after->time_s - before.time_s;
  if (gap > kLongestGap_s) return std::nullopt;
  return interpolated(before.pose, after->pose, (time_s - before.time_s) / gap);
}

bool OdometryTrack::isAround(double time_s) const {
  return !poses_.empty() && poses_.front().time_s <= time_s && time_s <= poses_.back().time_s;
}

double OdometryTrack::period_s() const {
  if (poses_.size() < 2) return 0.0;
  const double period_s = poses_.back().time_s - std::prev(poses_.end(), 2)->time_s;
  return period_s > kLongestGap_s ? 0.0 : period_s;
}

double OdometryTrack::standingFor() const {
  return stood_at_ ? poses_.back().time_s - stood_at_->time_s : 0.0;
}

}  // namespace handmap
