#include "core/plausibility/plausibility.h"

#include <algorithm>

#include "core/base/phrase.h"
#include "core/plausibility/checks.h"

namespace handmap {

namespace {

constexpr std::size_t kSamples = 40;

bool holds(const Doubts& doubts, const char* code) {
  return std::ranges::any_of(doubts, [code](const Doubt& doubt) { return doubt.code == code; });
}

}  // namespace

Doubts doubtsOf(const Recording& recording, const std::stop_token& stop) {
  Doubts doubts;
  for (const std::string& key : recording.strange_keys) {
    doubts.push_back({"strange_key", key, phrase("without it the usual value holds"), false, {}});
  }
  checkTimes(recording, doubts);
  checkOdometry(recording, stop, doubts);
  checkFiles(recording, doubts);
  checkPoints(recording, samplesOf(recording, kSamples, stop), doubts);
  checkFrozen(recording, stop, doubts);
  const bool measures = !holds(doubts, "points_units") && !holds(doubts, "odometry_units") &&
                        !holds(doubts, "two_clocks") && !holds(doubts, "odometry_heading") &&
                        !holds(doubts, "scans_repeated");
  if (measures) checkAgreement(recording, stop, doubts);
  return doubts;
}

Recording remedied(Recording recording, const Remedy& remedy) {
  PointsReading& as = recording.points_as;
  const PointsReading before = as;
  const PointsReading& more = remedy.points;
  as.xx = more.xx * before.xx + more.xy * before.yx;
  as.xy = more.xx * before.xy + more.xy * before.yy;
  as.yx = more.yx * before.xx + more.yy * before.yx;
  as.yy = more.yx * before.xy + more.yy * before.yy;
  as.scale = before.scale * more.scale;
  as.raise_m = before.raise_m + more.raise_m;
  if (remedy.range_limit_m > 0.0) recording.range_limit_m = remedy.range_limit_m;
  for (FrameRow& row : recording.rows) {
    row.time_s *= remedy.time_scale;
    if (row.right_time_s) *row.right_time_s *= remedy.time_scale;
  }
  std::vector<StampedPose> poses = recording.odometry.poses();
  for (auto& [time_s, pose] : poses) {
    time_s *= remedy.time_scale;
    const double heading = remedy.clockwise_headings ? -pose.heading : pose.heading;
    pose = {remedy.odometry_scale * pose.x, remedy.odometry_scale * pose.y,
            normalizedAngle(heading + remedy.odometry_turn)};
  }
  recording.odometry = Trajectory(std::move(poses), recording.odometry.source());
  return recording;
}

}  // namespace handmap
