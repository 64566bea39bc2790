// A pose graph with loops, some of them wrong, and Ceres as the check of what its solver finds.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include <ceres/autodiff_cost_function.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include "core/base/random.h"
#include "core/pose_graph/pose_graph.h"

namespace handmap::test {

/// Round after round along a square of 180 m; from the second round on every second pose is one of
/// the round before, and one in ten of these loops is 2 m off.
inline PoseGraph roundsAlongASquare(std::size_t rounds, RandomStream& random) {
  constexpr std::size_t kPoses = 100;
  const Eigen::Vector3d sigma(0.04, 0.03, 0.005);
  const Eigen::Vector3d loop_sigma(0.1, 0.1, 0.005);
  const auto measured = [&](const Pose2& from, const Pose2& to, const Eigen::Vector3d& by) {
    Pose2 motion = between(from, to);
    motion.x += by.x() * random.normal();
    motion.y += by.y() * random.normal();
    motion.heading += by.z() * random.normal();
    return MotionFactor{motion, by.cwiseInverse().asDiagonal()};
  };
  std::vector<Pose2> truth{{}};
  for (std::size_t i = 1; i < rounds * kPoses; ++i) {
    truth.push_back(truth.back() * Pose2{1.8, 0.0, i % 25 == 0 ? 0.5 * kPi : 0.0});
  }
  PoseGraph graph({truth.front()});
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const MotionFactor motion = measured(truth[i - 1], truth[i], sigma);
    graph.addPose(graph.poses().back() * motion.motion);
    graph.addEdge({i - 1, i, motion, 9.0});
  }
  for (std::size_t i = kPoses; i < truth.size(); i += 2) {
    MotionFactor loop = measured(truth[i - kPoses], truth[i], loop_sigma);
    if (i % 20 == 0) loop.motion.x += 2.0;
    graph.addEdge({i - kPoses, i, loop, 30.0});
  }
  return graph;
}

/// The residual of an edge as Ceres differentiates it.
struct CeresMotion {
  MotionFactor measured;

  template <typename T>
  bool operator()(const T* from, const T* to, T* residual) const {
    using std::cos;
    using std::floor;
    using std::sin;
    const T c = cos(from[2]);
    const T s = sin(from[2]);
    const T x = to[0] - from[0];
    const T y = to[1] - from[1];
    Eigen::Matrix<T, 3, 1> off(c * x + s * y - measured.motion.x, c * y - s * x - measured.motion.y,
                               to[2] - from[2] - measured.motion.heading);
    off[2] -= 2.0 * kPi * floor((off[2] + kPi) / (2.0 * kPi));
    Eigen::Map<Eigen::Matrix<T, 3, 1>> whitened(residual);
    whitened = measured.root_information.template cast<T>() * off;
    return true;
  }
};

/// The poses that Ceres finds from those that the graph has, on one thread, until a step gains less
/// than this share of the cost.
inline std::vector<Pose2> byCeres(const PoseGraph& graph, double least_gain) {
  std::vector<std::array<double, 3>> states;
  for (const Pose2& pose : graph.poses()) states.push_back({pose.x, pose.y, pose.heading});
  ceres::Problem problem;
  for (const GraphEdge& edge : graph.edges()) {
    auto residual = std::make_unique<CeresMotion>(CeresMotion{edge.motion});
    auto cost =
        std::make_unique<ceres::AutoDiffCostFunction<CeresMotion, 3, 3, 3>>(residual.release());
    auto kernel = std::make_unique<ceres::CauchyLoss>(std::sqrt(edge.kernel));
    problem.AddResidualBlock(cost.release(), kernel.release(), states[edge.from].data(),
                             states[edge.to].data());
  }
  problem.SetParameterBlockConstant(states.front().data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.max_num_iterations = 100;
  options.function_tolerance = least_gain;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  std::vector<Pose2> poses;
  for (const auto& state : states) poses.push_back({state[0], state[1], state[2]});
  return poses;
}

}  // namespace handmap::test
