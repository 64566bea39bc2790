// Poses held together by measured motions, some of which are wrong.
#pragma once

#include <span>
#include <vector>

#include "core/pose_graph/constants.h"
#include "core/pose_graph/motion_factor.h"
#include "core/pose_graph/normal_equations.h"

namespace handmap {

struct GraphEdge {
  std::size_t from = 0;
  std::size_t to = 0;
  MotionFactor motion;
  double kernel = 0.0;  ///< k of Cauchy's kernel on the squared residual
};

/// Levenberg-Marquardt; the first pose stays. The cost never rises, and what is not finite is never
/// taken.
class PoseGraph {
 public:
  explicit PoseGraph(std::vector<Pose2> poses = {}) : poses_(std::move(poses)) {}

  void addPose(const Pose2& pose) { poses_.push_back(pose); }
  void addEdge(const GraphEdge& edge) { edges_.push_back(edge); }
  /// Returns how many steps were taken.
  int optimize(int most_steps = pose_graph::kMostSteps);

  /// Of (x, y, heading) of some poses, the first held; as the edges weigh now. Not to be had: as if
  /// nothing held them.
  std::vector<Eigen::Matrix3d> covariances(std::span<const std::size_t> poses) const;
  Eigen::Matrix3d covariance(std::size_t pose) const { return covariances({&pose, 1}).front(); }

  const std::vector<Pose2>& poses() const { return poses_; }
  std::span<const GraphEdge> edges() const { return edges_; }
  double cost(const std::vector<Pose2>& poses) const;

 private:
  NormalEquations equations() const;

  std::vector<Pose2> poses_;
  std::vector<GraphEdge> edges_;
};

}  // namespace handmap
