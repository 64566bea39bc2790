#include "core/trajectory/pose_graph.h"

#include <cmath>

#include <Eigen/SparseCholesky>

#include "core/trajectory/constants.h"

namespace handmap {

using namespace trajectory;

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

void addBlock(Triplets& triplets, std::size_t row, std::size_t column,
              const Eigen::Matrix3d& block) {
  if (row == 0 || column == 0) return;  // the first pose stays
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      triplets.emplace_back(static_cast<int>(3 * (row - 1)) + i,
                            static_cast<int>(3 * (column - 1)) + j, block(i, j));
    }
  }
}

}  // namespace

struct PoseGraph::System {
  Eigen::SparseMatrix<double> information;
  Eigen::VectorXd gradient;
};

double PoseGraph::cost(const std::vector<Pose2>& poses) const {
  double sum = 0.0;
  for (const GraphEdge& edge : edges_) {
    const auto value = edge.motion.at(poses[edge.from], poses[edge.to]);
    sum += cauchyCost(value.residual.squaredNorm(), edge.kernel);
  }
  return sum;
}

PoseGraph::System PoseGraph::linearized() const {
  const auto size = static_cast<Eigen::Index>(3 * (poses_.size() - 1));
  System system{Eigen::SparseMatrix<double>(size, size), Eigen::VectorXd::Zero(size)};
  Triplets triplets;
  triplets.reserve(36 * edges_.size() + static_cast<std::size_t>(size));
  for (int i = 0; i < size; ++i) triplets.emplace_back(i, i, kLeastInformation);
  const auto push = [&](std::size_t pose, const Eigen::Vector3d& gradient) {
    if (pose > 0) {
      system.gradient.segment<3>(static_cast<Eigen::Index>(3 * (pose - 1))) += gradient;
    }
  };
  for (const GraphEdge& edge : edges_) {
    const auto value = edge.motion.at(poses_[edge.from], poses_[edge.to]);
    const double weight = cauchyWeight(value.residual.squaredNorm(), edge.kernel);
    const Eigen::Matrix3d from = weight * value.from_slope.transpose();
    const Eigen::Matrix3d to = weight * value.to_slope.transpose();
    addBlock(triplets, edge.from, edge.from, from * value.from_slope);
    addBlock(triplets, edge.from, edge.to, from * value.to_slope);
    addBlock(triplets, edge.to, edge.from, to * value.from_slope);
    addBlock(triplets, edge.to, edge.to, to * value.to_slope);
    push(edge.from, from * value.residual);
    push(edge.to, to * value.residual);
  }
  system.information.setFromTriplets(triplets.begin(), triplets.end());
  return system;
}

int PoseGraph::optimize(int most_steps) {
  if (poses_.size() < 2 || edges_.empty()) return 0;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;
  double damping = kFirstDamping;
  double now = cost(poses_);
  int taken = 0;
  for (int tried = 0; tried < most_steps; ++tried) {
    System system = linearized();
    system.information.diagonal() *= 1.0 + damping;
    if (tried == 0) solver.analyzePattern(system.information);
    solver.factorize(system.information);
    std::vector<Pose2> next = poses_;
    bool better = solver.info() == Eigen::Success;
    double then = now;
    if (better) {
      const Eigen::VectorXd step = -solver.solve(system.gradient);
      for (std::size_t i = 1; i < next.size(); ++i) {
        next[i] = stepped(next[i], step.segment<3>(static_cast<Eigen::Index>(3 * (i - 1))));
      }
      then = step.allFinite() ? cost(next) : now;
      better = std::isfinite(then) && then < now;
    }
    if (!better) {
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

Eigen::Matrix3d PoseGraph::covariance(std::size_t pose) const {
  if (pose == 0) return Eigen::Matrix3d::Zero();
  const System system = linearized();
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(system.information);
  const auto at = static_cast<Eigen::Index>(3 * (pose - 1));
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity() / kLeastInformation;
  if (solver.info() != Eigen::Success) return covariance;
  Eigen::Matrix3d solved;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Eigen::VectorXd column =
        solver.solve(Eigen::VectorXd::Unit(system.gradient.size(), at + k));
    solved.col(k) = column.segment<3>(at);
  }
  return solved.allFinite() ? solved : covariance;
}

}  // namespace handmap
