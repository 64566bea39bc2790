#include "drivers/onlookers/run_state.h"

#include <algorithm>

#include "core/base/phrase.h"

namespace handmap {

namespace {

constexpr double kStale_s = 2.0;  // a robot is metres farther by then

/// When it was last known where the robot is. Between two stops that is told by the odometry.
double knownUntil(const Snapshot& newest, const Rig& rig, const RigMonitor& monitor) {
  const auto odometry = monitor.odometry();
  const double told_s = newest.report.time_s;
  return rig.head && odometry ? std::max(told_s, odometry->time_s) : told_s;
}

}  // namespace

PoseState stateNow(const Snapshot* newest, const Rig& rig, const RigMonitor& monitor) {
  const bool is_over = monitor.endToken().stop_requested();
  if (newest == nullptr || is_over) return PoseState::Lost;
  if (monitor.now() - knownUntil(*newest, rig, monitor) > kStale_s) return PoseState::Lost;
  return poseState(newest->report);
}

const char* nameOf(PoseState state) {
  switch (state) {
    case PoseState::Sure:
      return "sure";
    case PoseState::Unsure:
      return "unsure";
    case PoseState::Lost:
      break;
  }
  return "lost";
}

std::string whyNow(PoseState state, const Snapshot* newest, const RigMonitor& monitor) {
  if (newest == nullptr) return phrase("nothing was observed yet");
  if (monitor.endToken().stop_requested()) return phrase("the drive has ended");
  const double silent_s = monitor.now() - newest->report.time_s;
  if (state == PoseState::Lost && silent_s > kStale_s) {
    return phrase("nothing was observed for {:.0f} s", silent_s);
  }
  return phrase("within {:.0f} m with {:.0f} %, within {:.0f} m with {:.0f} %", kWithin_m[1],
                100.0 * newest->report.within[1], kWithin_m[2], 100.0 * newest->report.within[2]);
}

std::vector<FrameLink> linksOf(const Snapshot& newest, const RigMonitor& monitor,
                               const Pose2* driven) {
  const auto named = monitor.frames();
  const OdometryFrames frames = named.value_or(OdometryFrames{});
  std::vector<FrameLink> links = {
      {"map", frames.odometry, newest.report.pose * inverse(newest.driven) * frames.origin}};
  if (!named && driven != nullptr) links.push_back({frames.odometry, frames.base, *driven});
  return links;
}

Eigen::Matrix3d poseCovariance(const FrameReport& report) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  covariance.topLeftCorner<2, 2>() = positionCovariance(report);
  covariance(2, 2) = report.pose_sigma[2] * report.pose_sigma[2];
  return covariance;
}

}  // namespace handmap
