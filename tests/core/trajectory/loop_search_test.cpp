#include "core/trajectory/loop_search.h"

#include <gtest/gtest.h>

#include "core/trajectory/scan_features.h"
#include "tests/core/trajectory/walled_world.h"

namespace handmap {
namespace {

TEST(LoopSearch, FindsAPlaceAgainOfWhichItKeptAPart) {
  const auto walls = test::ringCorridor();
  const std::vector<Pose2> trajectory = test::aroundTheBlock(1.2);
  RandomStream random(1);
  constexpr std::size_t kMost = 25'000;  // points; there are some 40,000
  LoopSearch search(kMost);
  std::vector<Pose2> poses;
  std::vector<Loop> loops;
  for (std::size_t i = 0; i < trajectory.size(); i += 4) {
    search.add(trajectory[i], planarFeatures(test::scanFrom(walls, trajectory[i], 0.03, random)));
    poses.push_back(trajectory[i]);
    EXPECT_LE(search.points(), kMost);
    for (const Loop& loop : search.search(poses, {})) loops.push_back(loop);
  }
  ASSERT_FALSE(loops.empty());
  for (const Loop& loop : loops) {
    const Pose2 truth = between(poses[loop.from], poses[loop.to]);
    EXPECT_LT((loop.motion.motion.position() - truth.position()).norm(), 0.3);
  }
}

}  // namespace
}  // namespace handmap
