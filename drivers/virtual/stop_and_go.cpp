#include "drivers/virtual/stop_and_go.h"

#include <algorithm>

namespace handmap {

namespace {

constexpr double kBackAhead_s = 0.5;
/// Who drives it does not wait longer for a head that does not move.
constexpr double kPatience_s = 60.0;

}  // namespace

StopAndGo::StopAndGo(std::vector<StampedPose> truth, std::vector<StampedPose> odometry)
    : truth_(std::move(truth), "virtual rig"),
      odometry_(std::move(odometry), "virtual rig"),
      way_s_(truth_.poses().front().time_s) {}

void StopAndGo::tick(double now_s, bool head_away) {
  const double passed_s = now_s - last_s_;
  last_s_ = now_s;
  const auto& stops = truth_.poses();
  if (stands_) {
    looked_ = looked_ || head_away;
    if (head_away || !looked_) ahead_since_s_ = now_s;
    const bool done = looked_ && now_s - ahead_since_s_ >= kBackAhead_s;
    const bool impatient = now_s - stands_since_s_ >= kPatience_s;
    if ((!done && !impatient) || next_ + 1 == stops.size()) return;
    ++next_;
    stands_ = looked_ = false;
    return;
  }
  way_s_ = std::min(way_s_ + passed_s, stops[next_].time_s);
  if (way_s_ < stops[next_].time_s) return;
  stands_ = true;
  stands_since_s_ = ahead_since_s_ = now_s;
}

Pose2 StopAndGo::pose() const { return *truth_.at(way_s_); }
Pose2 StopAndGo::odometry() const { return *odometry_.at(way_s_); }

}  // namespace handmap
