#include "core/odometry/given_poses.h"

#include <algorithm>
#include <span>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/odometry/constants.h"

namespace handmap {

using namespace odometry;

namespace {

/// One piece of the way, laid by odometry alone: its first pose is right, its last is to be `end`.
void bend(std::span<const StampedPose> laid, const Pose2& begin, const Pose2& end,
          std::vector<StampedPose>& corrections) {
  std::vector<double> driven(laid.size(), 0.0);
  for (std::size_t i = 1; i < laid.size(); ++i) {
    const Pose2 step = between(laid[i - 1].pose, laid[i].pose);
    driven[i] = driven[i - 1] + step.position().norm() + kMetresARadian * std::abs(step.heading);
  }
  const auto share = [&](std::size_t i) {
    if (driven.back() > 0.0) return driven[i] / driven.back();
    return laid.size() > 1 ? static_cast<double>(i) / static_cast<double>(laid.size() - 1) : 1.0;
  };
  const double turn =
      normalizedAngle(end.heading - begin.heading -
                      normalizedAngle(laid.back().pose.heading - laid.front().pose.heading));
  std::vector<Pose2> bent{begin};
  for (std::size_t i = 1; i < laid.size(); ++i) {
    Pose2 next = bent.back() * between(laid[i - 1].pose, laid[i].pose);
    next.heading = normalizedAngle(next.heading + turn * (share(i) - share(i - 1)));
    bent.push_back(next);
  }
  const Vec2 left = end.position() - bent.back().position();
  for (std::size_t i = 0; i < laid.size(); ++i) {
    const Vec2 at = bent[i].position() + share(i) * left;
    const Pose2 pose{at.x(), at.y(), bent[i].heading};
    corrections.push_back({laid[i].time_s, pose * inverse(laid[i].pose)});
  }
}

}  // namespace

GivenPoses::GivenPoses(const Pose2& start, const Pose2& start_odometry,
                       const std::vector<StampedPose>& odometry,
                       const std::vector<StampedPose>& given)
    : start_(start * inverse(start_odometry)) {
  const Trajectory recorded(odometry, "odometry");
  Pose2 begin = start;
  std::vector<StampedPose> piece{{given.empty() || odometry.empty()
                                      ? 0.0
                                      : std::min(odometry.front().time_s, given.front().time_s),
                                  start}};
  auto next = odometry.begin();
  for (const StampedPose& pose : given) {
    const auto here = recorded.at(pose.time_s);
    if (!here) {
      throw Error(ErrorCode::BadInput,
                  phrase("a pose is given at {} s, but the odometry of the run does not reach "
                         "there",
                         pose.time_s),
                  phrase("give times of the recording"));
    }
    for (; next != odometry.end() && next->time_s < pose.time_s; ++next) {
      if (next->time_s > piece.back().time_s) piece.push_back({next->time_s, start_ * next->pose});
    }
    if (piece.back().time_s >= pose.time_s) piece.pop_back();
    piece.push_back({pose.time_s, start_ * *here});
    bend(piece, begin, pose.pose, corrections_);
    given_s_.push_back(pose.time_s);
    begin = pose.pose;
    piece = {piece.back()};
  }
}

Eigen::Matrix3d GivenPoses::variance(double time_s) const {
  const auto until = std::upper_bound(given_s_.begin(), given_s_.end(), time_s);
  const auto count = static_cast<double>(std::distance(given_s_.begin(), until));
  return (count * handSigma().cwiseAbs2()).asDiagonal();
}

Pose2 GivenPoses::operator()(double time_s, const Pose2& odometry) const {
  if (corrections_.empty()) return odometry;
  const auto after = std::lower_bound(
      corrections_.begin(), corrections_.end(), time_s,
      [](const StampedPose& correction, double time) { return correction.time_s < time; });
  Pose2 correction = after == corrections_.end() ? corrections_.back().pose : after->pose;
  if (after != corrections_.begin() && after != corrections_.end()) {
    const StampedPose& before = *(after - 1);
    const double step = after->time_s - before.time_s;
    if (step > 0.0) {
      correction = interpolated(before.pose, after->pose, (time_s - before.time_s) / step);
    }
  }
  return inverse(start_) * (correction * (start_ * odometry));
}

}  // namespace handmap
