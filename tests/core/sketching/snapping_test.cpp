#include "core/sketching/snapping.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

constexpr double kReach = 1.0;
const Segment kWall{{0, 0}, {20, 0}};

Snap snapped(const Vec2& pointer, const SnapCandidates& candidates, SnapModes modes = {}) {
  return Snapper(modes, kReach, 0.5).snap(pointer, candidates);
}

TEST(Snapper, CornersAreStrongerThanWalls) {
  const Snap snap = snapped({19.4, 0.3}, {.walls = {kWall}});
  EXPECT_EQ(snap.kind, SnapKind::Corner);
  EXPECT_EQ(snap.point, Vec2(20, 0));
}

TEST(Snapper, PointsLieOnWallsAtTidyLengths) {
  const Snap snap = snapped({7.3333, 0.8}, {.walls = {kWall}});
  EXPECT_EQ(snap.kind, SnapKind::Wall);
  EXPECT_NEAR(snap.point.x(), 7.33, 1e-12);
  EXPECT_EQ(snap.point.y(), 0.0);
  ASSERT_EQ(snap.guides.size(), 1u);
}

TEST(Snapper, TheLineOfAWallDrawsBeyondItsEnds) {
  const Snap snap = snapped({42.0, 0.4}, {.walls = {kWall}});
  EXPECT_EQ(snap.kind, SnapKind::Line);
  EXPECT_EQ(snap.point.y(), 0.0);
  EXPECT_EQ(snapped({42.0, 0.9}, {.walls = {kWall}}).kind, SnapKind::None);
}

TEST(Snapper, RightAnglesToTheEdgeBefore) {
  const double turn = toRadians(30.0);
  const SnapCandidates candidates{.from = {Vec2(5, 5)}, .along = 3.0 * unitVector(turn)};
  const Vec2 across = perpendicular(unitVector(turn));
  const Snap snap = snapped(Vec2(5, 5) + 10.004 * across + 0.4 * unitVector(turn), candidates);
  EXPECT_EQ(snap.kind, SnapKind::RightAngle);
  EXPECT_NEAR((snap.point - Vec2(5, 5)).norm(), 10.0, 1e-9);
  EXPECT_NEAR((snap.point - Vec2(5, 5)).dot(unitVector(turn)), 0.0, 1e-9);
}

TEST(Snapper, TwoLinesCross) {
  const SnapCandidates candidates{.walls = {kWall}, .from = {Vec2(30, 12)}};
  const Snap snap = snapped({30.4, 0.3}, candidates);
  EXPECT_EQ(snap.kind, SnapKind::Crossing);
  EXPECT_NEAR((snap.point - Vec2(30, 0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(snap.guides.size(), 2u);
}

TEST(Snapper, ThePointBeforeIsNoTarget) {
  const SnapCandidates candidates{.walls = {kWall}, .from = {Vec2(0, 0)}};
  EXPECT_NE(snapped({0.5, 0.1}, candidates).kind, SnapKind::Corner);
}

TEST(Snapper, OnlyTheModesThatAreOn) {
  const SnapCandidates candidates{.walls = {kWall}};
  const Snap grid = snapped({19.6, 0.3}, candidates, {.grid = true, .objects = false});
  EXPECT_EQ(grid.kind, SnapKind::Grid);
  EXPECT_EQ(grid.point, Vec2(19.5, 0.5));
  const Snap none = snapped({19.604, 0.296}, candidates, {.grid = false, .objects = false});
  EXPECT_EQ(none.kind, SnapKind::None);
  EXPECT_EQ(none.point, Vec2(19.6, 0.3));
  const Snap both = snapped({10.1, 5.2}, candidates, {.grid = true, .objects = true});
  EXPECT_EQ(both.kind, SnapKind::Grid);
}

TEST(Snapper, NothingIsDrawnFartherThanItsReach) {
  for (double x = -3.0; x < 25.0; x += 0.137) {
    for (double y = -3.0; y < 3.0; y += 0.173) {
      const Snap snap =
          snapped({x, y}, {.walls = {kWall, {{3, -3}, {4, 9}}}, .from = {Vec2(8, 1)}});
      EXPECT_LE((snap.point - Vec2(x, y)).norm(), 1.5 * kReach + 0.01);
    }
  }
}

TEST(Snapper, AMovedShapeFitsWithOneOfItsCorners) {
  const std::vector<Vec2> corners = {{0, 10}, {5, 10}, {5, 14}, {0, 14}};
  const SnapCandidates candidates{.walls = {kWall}};
  const Snapper snapper({}, kReach, 0.5);
  const Snap to_corner = snapper.snapOffset(corners, {20.3, -9.6}, candidates);
  EXPECT_EQ(to_corner.kind, SnapKind::Corner);
  EXPECT_EQ(to_corner.point, Vec2(20, -10));
  const Snap to_wall = snapper.snapOffset(corners, {7.2, -9.6}, candidates);
  EXPECT_EQ(to_wall.kind, SnapKind::Wall);
  EXPECT_NEAR(to_wall.point.y(), -10.0, 1e-12);
  const Snap free = snapper.snapOffset(corners, {7.204, 30.0}, candidates);
  EXPECT_EQ(free.kind, SnapKind::None);
  EXPECT_EQ(free.point, Vec2(7.2, 30.0));
}

TEST(RoundedTo, GivesShortDecimals) {
  EXPECT_EQ(roundedTo({0.32, -0.28}, 0.1), Vec2(0.3, -0.3));
  EXPECT_EQ(roundedTo({1237.0, 12.0}, 25.0), Vec2(1225.0, 0.0));
}

}  // namespace
}  // namespace handmap
