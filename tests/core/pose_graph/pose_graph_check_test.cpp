#include <gtest/gtest.h>

#include "tests/core/pose_graph/ceres_pose_graph.h"

namespace handmap {
namespace {

TEST(PoseGraph, FindsTheMinimumThatCeresFinds) {
  for (const std::size_t rounds : {2U, 3U, 5U}) {
    RandomStream random(rounds);
    PoseGraph graph = test::roundsAlongASquare(rounds, random);
    const std::vector<Pose2> expected = test::byCeres(graph, 1e-12);
    const double before = graph.cost(graph.poses());
    for (int i = 0; i < 50; ++i) graph.optimize(1);
    const double least = graph.cost(expected);
    EXPECT_LT(least, 0.5 * before);
    EXPECT_NEAR(graph.cost(graph.poses()), least, 1e-6 * least) << rounds;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_LT((graph.poses()[i].position() - expected[i].position()).norm(), 1e-3)
          << rounds << " rounds, pose " << i;
    }
  }
}

}  // namespace
}  // namespace handmap
