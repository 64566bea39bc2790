#include "core/pose_graph/pose_graph.h"

#include <algorithm>
#include <array>

namespace handmap {

using namespace pose_graph;

namespace {

/// The first stays.
NormalEquations::Unknowns unknownsOf(std::size_t pose) {
  return {3 * (static_cast<int>(pose) - 1), 3};
}

}  // namespace

double PoseGraph::cost(const std::vector<Pose2>& poses) const {
  double sum = 0.0;
  for (const GraphEdge& edge : edges_) {
    const auto factor = edge.motion.at(poses[edge.from], poses[edge.to]);
    sum += cauchyCost(factor.residual.squaredNorm(), edge.kernel);
  }
  return sum;
}

NormalEquations PoseGraph::equations() const {
  NormalEquations equations(unknownsOf(poses_.size()).at);
  for (const GraphEdge& edge : edges_) {
    auto factor = edge.motion.at(poses_[edge.from], poses_[edge.to]);
    factor.weight *= cauchyWeight(factor.residual.squaredNorm(), edge.kernel);
    equations.add(factor, std::array{unknownsOf(edge.from), unknownsOf(edge.to)});
  }
  return equations;
}

int PoseGraph::optimize(int most_steps) {
  if (poses_.size() < 2 || edges_.empty()) return 0;
  NormalSolver solver;
  double damping = kFirstDamping;
  double now = cost(poses_);
  int taken = 0;
  for (int tried = 0; tried < most_steps; ++tried) {
    std::vector<Pose2> next = poses_;
    double then = now;
    if (const auto step = solver.solve(equations(), damping)) {
      for (std::size_t i = 1; i < next.size(); ++i) {
        next[i] = stepped(next[i], step->segment<3>(unknownsOf(i).at));
      }
      then = cost(next);
    }
    if (!(then < now)) {
      damping *= kDampingFactor;
      continue;
    }
    poses_ = std::move(next);
    ++taken;
    damping = std::max(damping / kDampingFactor, kFirstDamping);
    if (now - then < kLeastGain * now) break;
    now = then;
  }
  return taken;
}

std::vector<Eigen::Matrix3d> PoseGraph::covariances(std::span<const std::size_t> poses) const {
  NormalSolver solver;
  const bool solved = solver.solve(equations()).has_value();
  std::vector<Eigen::Matrix3d> covariances;
  for (const std::size_t pose : poses) {
    Eigen::Matrix3d& covariance = covariances.emplace_back(Eigen::Matrix3d::Zero());
    if (pose == 0) continue;
    if (!solved) covariance = kNotHeld * Eigen::Matrix3d::Identity();
    const int at = unknownsOf(pose).at;
    for (int k = 0; solved && k < 3; ++k) {
      covariance.col(k) = solver.covarianceColumn(at + k).segment<3>(at);
    }
  }
  return covariances;
}

}  // namespace handmap
