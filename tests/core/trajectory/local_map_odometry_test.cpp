#include "core/trajectory/local_map_odometry.h"

#include <gtest/gtest.h>

#include "core/trajectory/returns.h"
#include "tests/core/trajectory/walled_world.h"

namespace handmap {
namespace {

/// How many of the motions along a street it says that scans alone told.
int told(const std::vector<Segment>& walls) {
  RandomStream random(5);
  LocalMapOdometry odometry = LocalMapOdometry::ofGuesses();
  int count = 0;
  for (int i = 0; i < 20; ++i) {
    const Pose2 pose{0.15 * i, 0.0, 0.0};
    const auto points = test::scanFrom(walls, pose, 0.02, random);
    count += odometry.add(pose, features(usableReturns(points, 40.0))) ? 1 : 0;
  }
  return count;
}

TEST(LocalMapOdometry, TwoLongWallsDoNotTellHowFarItWent) {
  std::vector<Segment> walls{{{-200.0, 6.0}, {200.0, 6.0}}, {{-200.0, -6.0}, {200.0, -6.0}}};
  EXPECT_LT(told(walls), 3);
  walls.push_back({{15.0, -6.0}, {15.0, 6.0}});
  EXPECT_GT(told(walls), 16);
}

}  // namespace
}  // namespace handmap
