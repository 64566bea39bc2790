// Squaring up, and corners moved, added and taken away.
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/sketching/corners.h"
#include "core/sketching/squaring.h"

namespace handmap {
namespace {

const Polygon kL = {{0, 0}, {20, 0}, {20, 10}, {10, 10}, {10, 16}, {0, 16}};

Polygon shaken(Polygon polygon, double by, RandomStream& random) {
  for (Vec2& corner : polygon) corner += by * Vec2(random.normal(), random.normal());
  return polygon;
}

TEST(SquaredUp, GivesAShakenShapeItsRightAnglesBack) {
  RandomStream random(1, 0, 0);
  for (int round = 0; round < 200; ++round) {
    const double heading = random.uniform(-kPi, kPi);
    Polygon meant = kL;
    for (Vec2& corner : meant) corner = Pose2{100.0, 50.0, heading}.toOuter(corner);
    const auto squared = squaredUp(shaken(meant, 0.4, random));
    ASSERT_TRUE(squared);
    ASSERT_EQ(squared->size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
      const Vec2 in = (*squared)[i] - (*squared)[(i + 5) % 6];
      const Vec2 out = (*squared)[(i + 1) % 6] - (*squared)[i];
      EXPECT_NEAR(in.normalized().dot(out.normalized()), 0.0, 1e-9);
    }
    EXPECT_GT(intersectionOverUnion(*squared, meant), 0.85);
  }
}

TEST(SquaredUp, LeavesWhatIsSquareAndWhatIsMeantToSlant) {
  const auto same = squaredUp(kL);
  ASSERT_TRUE(same);
  for (std::size_t i = 0; i < kL.size(); ++i) EXPECT_LT(((*same)[i] - kL[i]).norm(), 1e-9);
  const Polygon bevelled = {{0, 0}, {30, 0}, {30, 14}, {24, 20}, {0, 20.4}};
  const auto squared = squaredUp(bevelled);
  ASSERT_TRUE(squared);
  ASSERT_EQ(squared->size(), 5u);
  const Vec2 bevel = (*squared)[3] - (*squared)[2];
  EXPECT_NEAR(std::atan2(bevel.y(), bevel.x()), std::atan2(6.0, -6.0), 1e-9);
}

TEST(SquaredUp, JoinsWallsInARow) {
  const auto squared = squaredUp({{0, 0}, {10, 0.1}, {20, 0}, {20, 10}, {0, 10}});
  ASSERT_TRUE(squared);
  EXPECT_EQ(squared->size(), 4u);
}

TEST(TurnToParallel, IsTheLeastTurn) {
  EXPECT_NEAR(turnToParallel(toRadians(100.0), 0.0), toRadians(-10.0), 1e-12);
  EXPECT_NEAR(turnToParallel(toRadians(-170.0), toRadians(5.0)), toRadians(-5.0), 1e-12);
}

TEST(Corners, AreMovedAddedAndTakenAway) {
  const auto moved = withCornerAt(kL, 3, {12, 10});
  ASSERT_TRUE(moved);
  EXPECT_EQ((*moved)[3], Vec2(12, 10));
  const auto added = withCornerOn(kL, 5, {0, 8});
  ASSERT_TRUE(added);
  EXPECT_EQ(added->size(), 7u);
  EXPECT_EQ(added->back(), Vec2(0, 8));
  EXPECT_EQ(withoutCorner(*added, 6), kL);
}

TEST(Corners, WhatWouldCrossIsRefused) {
  EXPECT_FALSE(withCornerAt(kL, 3, {30, -5}));
  EXPECT_FALSE(withCornerOn(kL, 0, {10, 30}));
  EXPECT_FALSE(withoutCorner({{0, 0}, {1, 0}, {0, 1}}, 1));
  EXPECT_FALSE(withoutCorner(kL, 0) && withoutCorner(kL, 0)->size() != 5);
}

TEST(Corners, TheNearestIsFound) {
  EXPECT_EQ(cornerNear(kL, {19, 1}, 2.0), std::optional<std::size_t>(1));
  EXPECT_FALSE(cornerNear(kL, {5, 5}, 2.0));
  EXPECT_FALSE(edgeNear(kL, {-0.5, 7}, 1.0, 5));  // the closing one is left out
  EXPECT_EQ(edgeNear(kL, {-0.5, 7}, 1.0, 6), std::optional<std::size_t>(5));
}

}  // namespace
}  // namespace handmap
