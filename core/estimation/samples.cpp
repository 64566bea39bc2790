#include "core/estimation/samples.h"

#include <algorithm>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "core/estimation/constants.h"
#include "core/estimation/drawing/constants.h"

namespace handmap {

using namespace estimation;

std::vector<std::size_t> sampledHypotheses(std::span<const Hypothesis> hypotheses,
                                           std::size_t count) {
  std::vector<std::size_t> sampled;
  double sum = hypotheses.front().weight;
  for (std::size_t i = 0, h = 0; i < count; ++i) {
    const double at = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    while (sum < at && h + 1 < hypotheses.size()) sum += hypotheses[++h].weight;
    sampled.push_back(h);
  }
  return sampled;
}

PoseSampler::PoseSampler(const Pose2& mean, const Eigen::Matrix3d& covariance) : mean_(mean) {
  const Eigen::LLT<Eigen::Matrix3d> factor(covariance +
                                           drawing::kLeastVariance * Eigen::Matrix3d::Identity());
  root_ = factor.matrixL();
}

Pose2 PoseSampler::operator()(RandomStream& random) const {
  const Eigen::Vector3d unit(random.normals<3>().data());
  const Eigen::Vector3d offset = root_ * unit;
  return {mean_.x + offset.x(), mean_.y + offset.y(), normalizedAngle(mean_.heading + offset.z())};
}

BuildingSampler::BuildingSampler(const RefinedBuilding& refined) : walls_(refined.walls) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> axes(refined.covariance);
  root_ = axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

Rectangle BuildingSampler::operator()(RandomStream& random) const {
  const Eigen::Vector4d unit(random.normals<4>().data());
  const Eigen::Vector4d offset = root_ * unit;
  Box box = walls_;
  for (std::size_t k = 0; k < 4; ++k) box.reach[k] += offset[static_cast<Eigen::Index>(k)];
  Rectangle rectangle = box.rectangle();
  rectangle.width = std::max(rectangle.width, kLeastShown_m);
  rectangle.depth = std::max(rectangle.depth, kLeastShown_m);
  return rectangle;
}

}  // namespace handmap
