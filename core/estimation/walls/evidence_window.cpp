#include "core/estimation/walls/evidence_window.h"

#include <cmath>

namespace handmap {

namespace {

constexpr double kMoved = 0.08;    // metres; choice: a sixth of a cell
constexpr double kTurned = 0.005;  // radians; choice: 10 cm at 20 m
constexpr int kMostAnew = 4;  // frames put in anew with each that is added; choice: so much time

}  // namespace

bool EvidenceWindow::isOutdated(const ActiveFrame& active) const {
  if (active.held_by != sensor_) return true;
  const Pose2 motion = between(active.held_at, active.frame->pose);
  return std::hypot(motion.x, motion.y) > kMoved || std::abs(motion.heading) > kTurned;
}

void EvidenceWindow::add(Frame& frame) {
  std::vector<ActiveFrame> out;
  std::vector<ActiveFrame> in;
  std::vector<ActiveFrame> kept;
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const ActiveFrame& old = frames_[i];
    const bool far = (old.frame->pose.position() - frame.pose.position()).norm() > reach_m_;
    (far || frames_.size() - i >= most_ ? out : kept).push_back(old);
  }
  frames_ = std::move(kept);
  int anew = 0;
  for (auto it = frames_.rbegin(); it != frames_.rend() && anew < kMostAnew; ++it) {
    if (!isOutdated(*it)) continue;
    out.push_back(*it);
    *it = {it->frame, it->frame->pose, sensor_};
    in.push_back(*it);
    ++anew;
  }
  frames_.push_back({&frame, frame.pose, sensor_});
  in.push_back(frames_.back());
  evidence_.change(out, in);
}

void EvidenceWindow::reinsertAll(const std::stop_token& stop) {
  if (stop.stop_requested()) return;
  for (ActiveFrame& active : frames_) active = {active.frame, active.frame->pose, sensor_};
  evidence_.putAnew(frames_);
}

}  // namespace handmap
