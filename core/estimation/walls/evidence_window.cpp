#include "core/estimation/walls/evidence_window.h"

#include <cmath>

namespace handmap {

namespace {

constexpr double kMoved = 0.08;    // metres; choice: a sixth of a cell
constexpr double kTurned = 0.005;  // radians; choice: 10 cm at 20 m
constexpr int kMostMoved = 3;  // frames put in anew with each that is added; choice: so much time

bool hasMoved(const ActiveFrame& active) {
  const Pose2 motion = between(active.held_at, active.frame->pose);
  return std::hypot(motion.x, motion.y) > kMoved || std::abs(motion.heading) > kTurned;
}

}  // namespace

void EvidenceWindow::add(Frame& frame, const SensorModel& sensor) {
  std::vector<ActiveFrame> kept;
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const ActiveFrame& old = frames_[i];
    const bool far = (old.frame->pose.position() - frame.pose.position()).norm() > reach_m_;
    if (far || frames_.size() - i >= most_) {
      evidence_.remove(*old.frame, old.held_at, sensor);
    } else {
      kept.push_back(old);
    }
  }
  frames_ = std::move(kept);
  int moved = 0;
  for (auto it = frames_.rbegin(); it != frames_.rend() && moved < kMostMoved; ++it) {
    if (!hasMoved(*it)) continue;
    reinsert(*it, sensor);
    ++moved;
  }
  frames_.push_back({&frame, frame.pose});
  evidence_.add(frame, frame.pose, sensor);
}

void EvidenceWindow::reinsert(ActiveFrame& active, const SensorModel& sensor) {
  evidence_.remove(*active.frame, active.held_at, sensor);
  active.held_at = active.frame->pose;
  evidence_.add(*active.frame, active.held_at, sensor);
}

void EvidenceWindow::reinsertAll(const SensorModel& sensor, const std::stop_token& stop) {
  if (stop.stop_requested()) return;
  for (ActiveFrame& active : frames_) active.held_at = active.frame->pose;
  evidence_.putAnew(frames_, sensor);
}

void EvidenceWindow::changeSensor(SensorModel& sensor, const SensorOptions& options) {
  sensor = SensorModel(options, sensor.rangeLimit());
  evidence_.putAnew(frames_, sensor);
}

}  // namespace handmap
