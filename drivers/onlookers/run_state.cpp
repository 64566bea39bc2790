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

Certainty stateNow(const Snapshot* newest, const Rig& rig, const RigMonitor& monitor) {
  const bool is_over = monitor.endToken().stop_requested();
  if (newest == nullptr || is_over) return Certainty::Lost;
  if (monitor.now() - knownUntil(*newest, rig, monitor) > kStale_s) return Certainty::Lost;
  return certaintyOf(newest->report).kind;
}

const char* nameOf(Certainty state) {
  switch (state) {
    case Certainty::Sure:
      return "sure";
    case Certainty::Rough:
      return "unsure";
    case Certainty::Lost:
      break;
  }
  return "lost";
}

std::string whyNow(Certainty state, const Snapshot* newest, const RigMonitor& monitor) {
  if (newest == nullptr) return phrase("nothing was observed yet");
  if (monitor.endToken().stop_requested()) return phrase("the drive has ended");
  const double silent_s = monitor.now() - newest->report.time_s;
  if (state == Certainty::Lost && silent_s > kStale_s) {
    return phrase("nothing was observed for {:.0f} s", silent_s);
  }
  const PoseCertainty certainty = certaintyOf(newest->report);
  return phrase("nine times of ten within {:.1f} m and {:.0f}°", certainty.within_m,
                toDegrees(certainty.heading_rad));
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

}  // namespace handmap
