#include "drivers/live/stop_scan.h"

#include <cmath>

#include "core/base/phrase.h"

namespace handmap {

namespace {

// A PTU-D46 turns by 180° in 3 s; slower ones exist.
constexpr double kTurnPatience_s = 15.0;
constexpr double kPairPatience_s = 3.0;
constexpr double kWheelPatience_s = 1.0;  // of odometry that comes several times a second
/// The head still trembles when it says that it stands, and the exposure takes its time.
constexpr double kSettle_s = 0.15;
constexpr double kPanTolerance = 0.02;  // radians: more than a step of any head
// A robot that is nudged while it looks around has not left; one that drives has.
constexpr double kLeft_m = 0.05;
constexpr double kLeft_rad = 0.05;

bool isAt(double pan, double wanted) {
  return std::abs(normalizedAngle(pan - wanted)) <= kPanTolerance;
}

}  // namespace

StopScan::Action StopScan::look(double now_s) {
  state_ = State::Turning;
  since_s_ = now_s;
  return {Action::Kind::Look, pan()};
}

StopScan::Action StopScan::drop(const std::string& reason) {
  state_ = State::Waiting;
  next_ = 0;
  return {Action::Kind::Drop, 0.0, {}, reason};
}

std::optional<StopScan::Action> StopScan::moved(double time_s, const Pose2& pose,
                                                double standing_for_s) {
  now_s_ = time_s;
  has_moved_ = true;
  if (state_ != State::Waiting) {
    const bool left = (pose.position() - pose_.position()).norm() > kLeft_m ||
                      std::abs(normalizedAngle(pose.heading - pose_.heading)) > kLeft_rad;
    if (!left) return std::nullopt;
    return drop(phrase("the robot drove on while it looked around"));
  }
  if (standing_for_s < options_.standing_s) return std::nullopt;
  const bool elsewhere =
      !looked_at_ || (pose.position() - looked_at_->position()).norm() >= options_.every_m;
  if (!wanted_ && !(options_.automatic && elsewhere)) return std::nullopt;
  pose_ = pose;
  return begin(time_s);
}

StopScan::Action StopScan::begin(double now_s) {
  next_ = 0;
  missed_.clear();
  by_person_ = wanted_;
  return look(now_s);
}

void StopScan::trigger() {
  wanted_ = true;
  has_moved_ = false;
  wanted_since_s_.reset();
}

std::optional<StopScan::Action> StopScan::arrived(double time_s, double at_pan) {
  if (state_ != State::Turning || !isAt(at_pan, pan())) return std::nullopt;
  state_ = State::Taking;
  since_s_ = time_s;
  return std::nullopt;
}

std::optional<StopScan::Action> StopScan::pairTaken(double time_s) {
  if (state_ != State::Taking || time_s < since_s_ + kSettle_s) return std::nullopt;
  state_ = State::Taken;  // the next tick() drives on, or delivers
  return Action{Action::Kind::Take, pan()};
}

std::optional<StopScan::Action> StopScan::headLost() {
  if (state_ == State::Waiting) return std::nullopt;
  return drop(phrase("the head was lost while it looked around"));
}

std::optional<StopScan::Action> StopScan::tick(double now_s) {
  now_s_ = now_s;
  if (state_ == State::Waiting) return lookWithoutWheels(now_s);
  if (state_ == State::Taken) {
    if (++next_ < options_.pans.size()) return look(now_s);
    wanted_ = false;
    if (!missed_.empty()) return drop(missed_);
    state_ = State::Waiting;
    next_ = 0;
    looked_at_ = pose_;
    return Action{Action::Kind::Deliver, 0.0, pose_};
  }
  if (state_ == State::Turning && now_s - since_s_ > kTurnPatience_s) {
    return drop(phrase("the head did not arrive"));
  }
  if (state_ == State::Taking && now_s - since_s_ > kPairPatience_s) {
    missed_ = phrase("no pair of images came while the head stood");
    if (!by_person_) return drop(missed_);
    state_ = State::Taken;  // who asked for it sees the head go around all the same
  }
  return std::nullopt;
}

/// Who asks for it while nothing tells a motion says that the robot stands.
std::optional<StopScan::Action> StopScan::lookWithoutWheels(double now_s) {
  if (!wanted_ || has_moved_) return std::nullopt;
  if (!wanted_since_s_) wanted_since_s_ = now_s;
  if (now_s - *wanted_since_s_ < kWheelPatience_s) return std::nullopt;
  const Action first = begin(now_s);
  missed_ = phrase("no odometry came: it is not known where");
  return first;
}

std::string StopScan::describe() const {
  if (state_ != State::Waiting) {
    return phrase("the head looks around: {} of {}", next_ + 1, options_.pans.size());
  }
  const bool will = wanted_ || (options_.automatic && !looked_at_);
  return will ? phrase("the head looks around when the robot stands") : "";
}

}  // namespace handmap
