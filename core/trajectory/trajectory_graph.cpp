#include "core/trajectory/trajectory_graph.h"

#include "core/trajectory/constants.h"

namespace handmap {

using namespace trajectory;

MotionFactor TrajectoryGraph::edge(const Odometry& to) const {
  const Pose2 motion = between(last_.pose, to.pose);
  return loosened({motion, rootOf(variance_.inverse()).value_or(Eigen::Matrix3d::Identity())},
                  guessedOf(last_, to));
}

bool TrajectoryGraph::add(const Odometry& now, const std::vector<ScanPoint>& scan,
                          const Eigen::Matrix3d& variance, const std::stop_token& stop) {
  variance_ += variance;
  const Pose2& smooth = now.pose;
  if (smooth_.empty()) {
    graph_.addPose(smooth);
  } else {
    const Pose2 motion = between(smooth_.back(), smooth);
    const bool far = motion.position().norm() >= kKeyframe_m || mayBeFar(guessedOf(last_, now));
    if (!far) return false;
    const std::size_t last = smooth_.size() - 1;
    graph_.addPose(graph_.poses().back() * motion);
    graph_.addEdge({last, last + 1, edge(now), kKernel});
  }
  variance_.setZero();
  smooth_.push_back(smooth);
  last_ = now;
  search_.add(smooth, scan);
  if (!close_loops_ || smooth_.size() % 2 == 0) return false;  // neighbours tell the same
  const std::vector<Loop> loops = search_.search(graph_.poses(), stop);
  for (const Loop& loop : loops) graph_.addEdge({loop.from, loop.to, loop.motion, kLoopKernel});
  loops_ += static_cast<int>(loops.size());
  return !loops.empty() && graph_.optimize() > 0;
}

Pose2 TrajectoryGraph::corrected(const Pose2& smooth, std::size_t keyframe) const {
  const Pose2 since = between(smooth_[keyframe], smooth);
  const Pose2 pose = graph_.poses()[keyframe] * since;
  if (keyframe + 1 >= smooth_.size()) return pose;
  const Pose2 until = between(smooth_[keyframe + 1], smooth);
  const double before = since.position().norm();
  const double after = until.position().norm();
  const double share = before + after > 0.0 ? before / (before + after) : 0.0;
  return interpolated(pose, graph_.poses()[keyframe + 1] * until, share);
}

}  // namespace handmap
