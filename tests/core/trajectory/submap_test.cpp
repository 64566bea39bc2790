#include "core/trajectory/submap.h"

#include <gtest/gtest.h>

#include "tests/core/trajectory/walled_world.h"

namespace handmap {
namespace {

std::vector<ScanPoint> seenFrom(const Pose2& pose) {
  RandomStream random(7);
  return planarFeatures(test::scanFrom(test::ringCorridor(), pose, 0.02, random));
}

const Pose2 kThere{30.0, 5.0, 0.3};

TEST(WallGrid, FindsWhereThePiecesLie) {
  const WallGrid grid(moved(seenFrom(kThere), kThere));
  const Pose2 off{kThere.x + 1.4, kThere.y - 0.9, kThere.heading + 0.07};
  const auto found = grid.find(seenFrom(kThere), off, {3.0, 0.15});
  ASSERT_TRUE(found);
  EXPECT_LT((found->position() - kThere.position()).norm(), 0.6);
  EXPECT_NEAR(found->heading, kThere.heading, 0.03);
}

TEST(WallGrid, FindsItAsWellFarAway) {
  RandomStream random(3);
  std::vector<ScanPoint> seen;
  for (int i = 0; i < 200; ++i) {
    const Vec2 at(random.uniform(-30.0, 30.0), random.uniform(-30.0, 30.0));
    seen.push_back({at, unitVector(random.uniform(-kPi, kPi))});
  }
  const WallGrid grid(moved(seen, kThere));
  for (const Pose2& by :
       {Pose2{11.0, -10.5, 0.2}, Pose2{-0.5, 1.0, 0.0}, Pose2{-9.0, 11.5, -0.16}}) {
    const Pose2 off{kThere.x + by.x, kThere.y + by.y, kThere.heading + by.heading};
    const auto found = grid.find(seen, off, {12.0, 0.22});
    ASSERT_TRUE(found);
    EXPECT_LT((found->position() - kThere.position()).norm(), 0.6);
    EXPECT_NEAR(found->heading, kThere.heading, 0.021);
  }
}

TEST(WallGrid, HasNothingBeyondItsWindow) {
  const WallGrid grid(moved(seenFrom(kThere), kThere));
  const Pose2 off{kThere.x + 6.0, kThere.y, kThere.heading};
  EXPECT_FALSE(grid.find(seenFrom(kThere), off, {3.0, 0.1}));
}

TEST(WallGrid, IsNotSureInABareCorridor) {
  std::vector<ScanPoint> walls;
  for (int i = -300; i <= 300; ++i) {
    walls.push_back({{0.1 * i, 3.0}, {0.0, -1.0}});
    walls.push_back({{0.1 * i, -3.0}, {0.0, 1.0}});
  }
  std::vector<ScanPoint> seen = walls;
  std::erase_if(seen, [](const ScanPoint& p) { return std::abs(p.at.x()) > 15.0; });
  EXPECT_FALSE(WallGrid(walls).find(seen, {}, {4.0, 0.1}));
}

TEST(WallGrid, FindsNothingInNothing) {
  EXPECT_FALSE(WallGrid({}).find(seenFrom(kThere), {}, {2.0, 0.1}));
  EXPECT_FALSE(WallGrid(seenFrom(kThere)).find({}, {}, {2.0, 0.1}));
}

TEST(PointMap, KeepsToItsKindAndForgets) {
  PointMap map;
  map.add({{{1.0, 1.0}, {1.0, 0.0}}, {{1.2, 1.0}, {0.0, 0.0}}}, 1);
  map.add({{{1.1, 1.0}, {-1.0, 0.0}}}, 2);
  const ScanPoint wall{{1.0, 1.1}, {1.0, 0.0}};
  ASSERT_TRUE(map.nearest(wall, 0.5));
  EXPECT_EQ(map.nearest(wall, 0.5)->at, Vec2(1.0, 1.0));
  EXPECT_EQ(map.nearest({{1.0, 1.1}, {0.0, 0.0}}, 0.5)->at, Vec2(1.2, 1.0));
  EXPECT_FALSE(map.nearest(wall, 0.05));
  map.dropBefore(2);
  EXPECT_FALSE(map.nearest(wall, 0.5));
  EXPECT_TRUE(map.nearest({{1.0, 1.0}, {-1.0, 0.0}}, 0.5));
}

}  // namespace
}  // namespace handmap
