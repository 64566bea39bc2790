#include "core/pose_graph/pose_graph.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

constexpr std::size_t kSide = 10;

MotionFactor motion(const Pose2& measured, double position_m, double heading) {
  return {measured, Eigen::Vector3d(position_m, position_m, heading).cwiseInverse().asDiagonal()};
}

/// Around a square and back to the start.
std::vector<Pose2> square() {
  std::vector<Pose2> poses{{}};
  for (std::size_t i = 1; i <= 4 * kSide; ++i) {
    const double turn = i % kSide == 0 ? 0.5 * kPi : 0.0;
    poses.push_back(poses.back() * Pose2{2.0, 0.0, turn});
  }
  return poses;
}

/// Each motion turns a little too far.
PoseGraph drifting(const std::vector<Pose2>& truth) {
  PoseGraph graph({truth.front()});
  for (std::size_t i = 1; i < truth.size(); ++i) {
    Pose2 measured = between(truth[i - 1], truth[i]);
    measured.heading += 0.005;
    graph.addPose(graph.poses().back() * measured);
    graph.addEdge({i - 1, i, motion(measured, 0.05, 0.01), 9.0});
  }
  return graph;
}

double worst(const std::vector<Pose2>& poses, const std::vector<Pose2>& truth) {
  double most = 0.0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    most = std::max(most, (poses[i].position() - truth[i].position()).norm());
  }
  return most;
}

TEST(PoseGraph, SpreadsTheErrorOfALoop) {
  const auto truth = square();
  PoseGraph graph = drifting(truth);
  EXPECT_GT(worst(graph.poses(), truth), 2.5);
  graph.addEdge({0, truth.size() - 1, motion(truth.back(), 0.1, 0.005), 30.0});
  EXPECT_GT(graph.optimize(20), 0);
  EXPECT_LT(worst(graph.poses(), truth), 0.6);
  EXPECT_EQ(graph.poses().front(), truth.front());
}

TEST(PoseGraph, IsNotTakenInByOneWrongLoop) {
  const auto truth = square();
  PoseGraph graph = drifting(truth);
  for (const std::size_t before : {0U, 1U, 2U, 3U}) {
    const std::size_t i = truth.size() - 1 - before;
    graph.addEdge({0, i, motion(truth[i], 0.1, 0.005), 30.0});
  }
  graph.addEdge({5, 25, motion({3.0, 1.0, 0.3}, 0.1, 0.005), 30.0});
  graph.optimize(50);
  EXPECT_LT(worst(graph.poses(), truth), 1.0);
}

TEST(PoseGraph, NeverGetsWorse) {
  const auto truth = square();
  PoseGraph graph = drifting(truth);
  graph.addEdge({0, truth.size() - 1, motion(truth.back(), 0.01, 0.001), 30.0});
  double before = graph.cost(graph.poses());
  for (int i = 0; i < 5; ++i) {
    graph.optimize(1);
    const double after = graph.cost(graph.poses());
    EXPECT_LE(after, before);
    before = after;
  }
}

TEST(PoseGraph, RefusesWhatIsNotFinite) {
  PoseGraph graph({Pose2{}, Pose2{1.0, 0.0, 0.0}});
  MotionFactor broken = motion({1.0, 0.0, 0.0}, 0.1, 0.01);
  broken.root_information(0, 0) = std::numeric_limits<double>::infinity();
  graph.addEdge({0, 1, broken, 9.0});
  EXPECT_EQ(graph.optimize(10), 0);
  EXPECT_EQ(graph.poses()[1], (Pose2{1.0, 0.0, 0.0}));
}

TEST(PoseGraph, LeavesWhatNothingHolds) {
  PoseGraph graph({Pose2{}, Pose2{1.0, 0.0, 0.0}, Pose2{2.0, 0.0, 0.0}});
  graph.addEdge({0, 1, motion({1.1, 0.0, 0.0}, 0.1, 0.01), 9.0});
  graph.optimize(10);
  EXPECT_EQ(graph.poses()[2], (Pose2{2.0, 0.0, 0.0}));
}

TEST(PoseGraph, KnowsHowUncertainAPoseIs) {
  PoseGraph graph({Pose2{}});
  graph.addPose({10.0, 0.0, 0.0});
  graph.addEdge({0, 1, motion({10.0, 0.0, 0.0}, 0.3, 0.02), 9.0});
  graph.addPose({10.0, 10.0, 0.0});
  graph.addEdge({1, 2, motion({0.0, 10.0, 0.0}, 0.4, 0.02), 9.0});
  EXPECT_TRUE(graph.covariance(0).isZero());
  EXPECT_NEAR(graph.covariance(1)(0, 0), 0.09, 1e-6);
  EXPECT_NEAR(graph.covariance(1)(2, 2), 4e-4, 1e-8);
  // The heading of the first swings the second: 10 m · 0.02 across.
  EXPECT_NEAR(graph.covariance(2)(0, 0), 0.09 + 0.16 + 0.04, 1e-6);
  EXPECT_NEAR(graph.covariance(2)(1, 1), 0.09 + 0.16, 1e-6);
  EXPECT_NEAR(graph.covariance(2)(2, 2), 8e-4, 1e-8);
  // A second way to the same place makes it surer; what nothing holds is not known.
  graph.addEdge({0, 2, motion({10.0, 10.0, 0.0}, 0.1, 0.02), 9.0});
  EXPECT_LT(graph.covariance(2)(0, 0), 0.01);
  graph.addPose({});
  EXPECT_GT(graph.covariance(3)(0, 0), 1e6);
}

}  // namespace
}  // namespace handmap
