// Samples of what the estimator knows, for those who show it.
#pragma once

#include <span>
#include <vector>

#include "core/base/random.h"
#include "core/estimation/drawing/refined_building.h"
#include "core/estimation/labels/assignment.h"

namespace handmap {

/// `count` hypotheses, by index, each as often as its weight says (low-variance sampling).
std::vector<std::size_t> sampledHypotheses(std::span<const Hypothesis> hypotheses,
                                           std::size_t count);

/// Of a pose with a covariance of (x, y, heading).
class PoseSampler {
 public:
  PoseSampler(const Pose2& mean, const Eigen::Matrix3d& covariance);
  Pose2 operator()(RandomStream& random) const;

 private:
  Pose2 mean_;
  Eigen::Matrix3d root_;
};

/// Of a building: its walls move together as they are known together.
class BuildingSampler {
 public:
  explicit BuildingSampler(const RefinedBuilding& refined);
  Rectangle operator()(RandomStream& random) const;

 private:
  Box walls_;
  Eigen::Matrix4d root_;
};

}  // namespace handmap
