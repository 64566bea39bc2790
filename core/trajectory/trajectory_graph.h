// The keyframes of a way: local map odometry between them, and loops.
#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/pose_graph/pose_graph.h"
#include "core/recording/odometry.h"
#include "core/trajectory/loop_search.h"

namespace handmap {

class TrajectoryGraph {
 public:
  explicit TrajectoryGraph(bool close_loops) : close_loops_(close_loops) {}

  /// Takes the next scan as a keyframe where it is far enough from the last one. `variance`: how
  /// far the motion to it strays. Returns whether the poses of before have changed.
  bool add(const Odometry& smooth, const std::vector<ScanPoint>& scan,
           const Eigen::Matrix3d& variance, const std::stop_token& stop);

  /// Where a scan between two keyframes, or after the last, was.
  Pose2 corrected(const Pose2& smooth, std::size_t keyframe) const;
  /// Of the newest keyframe's pose, given the first.
  Eigen::Matrix3d covariance() const { return graph_.covariance(smooth_.size() - 1); }
  /// The same of some keyframes.
  std::vector<Eigen::Matrix3d> covariances(std::span<const std::size_t> keyframes) const {
    return graph_.covariances(keyframes);
  }
  std::size_t keyframes() const { return smooth_.size(); }
  int loops() const { return loops_; }

 private:
  MotionFactor edge(const Odometry& to) const;

  bool close_loops_;
  LoopSearch search_;
  PoseGraph graph_;
  std::vector<Pose2> smooth_;
  Odometry last_;                                       ///< of smooth_
  Eigen::Matrix3d variance_ = Eigen::Matrix3d::Zero();  ///< since the last keyframe
  int loops_ = 0;
};

}  // namespace handmap
