#include "core/estimation/walls/evidence_window.h"

#include <cmath>

#include "core/estimation/walls/constants.h"

namespace handmap {

using namespace walls;

bool EvidenceWindow::isOutdated(const ActiveFrame& active) const {
  if (active.held_by != sensor_) return true;
  const Pose2 motion = between(active.held_at, active.frame->pose);
  return std::hypot(motion.x, motion.y) > kMoved_m || std::abs(motion.heading) > kTurned;
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
