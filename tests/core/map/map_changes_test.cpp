#include "core/map/map_changes.h"

#include <gtest/gtest.h>

#include "core/map/certainty.h"

namespace handmap {
namespace {

Building at(const char* id, double x, int observations) {
  Building building;
  building.id = id;
  building.shape = Rectangle{{x, 0.0}, 10.0, 10.0, 0.0};
  building.estimate = Estimate{0.1, 0.1, 0.1, observations};
  return building;
}

TEST(MapChanges, SortsTheBuildingsByWhatBecameOfThem) {
  Map drawing;
  drawing.buildings = {at("near", 0.0, 0), at("far", 0.0, 0), at("kept", 0.0, 0),
                       at("unseen", 0.0, 0), at("new", 0.0, 0)};
  Map refined = drawing;
  refined.buildings = {at("near", 0.5, 3), at("far", 4.0, 3), at("kept", 0.05, 3),
                       at("unseen", 2.0, 0), at("new", 1.0, 1)};
  setDoubt(refined.buildings[0], 0.2);
  setDoubt(refined.buildings[3], 0.6);
  const MapChanges changes = changesOf(drawing, refined);
  ASSERT_EQ(changes.moved.size(), 3U);
  EXPECT_EQ(changes.moved.front().building, 1U);
  EXPECT_DOUBLE_EQ(changes.moved.front().moved_m(), 4.0);
  EXPECT_EQ(changes.moved.back().building, 0U);
  ASSERT_EQ(changes.kept.size(), 1U);
  EXPECT_EQ(changes.kept.front().building, 2U);
  ASSERT_EQ(changes.unseen.size(), 1U);
  ASSERT_EQ(changes.doubtful.size(), 2U);
  EXPECT_EQ(changes.doubtful.front().building, 3U);
}

TEST(MapChanges, ABuildingThatTurnsOrGrowsWhereItStandsIsNotKept) {
  Map drawing;
  drawing.buildings = {at("turned", 0.0, 0), at("grown", 50.0, 0), at("kept", 100.0, 0)};
  Map refined = drawing;
  for (Building& building : refined.buildings) building.estimate->observations = 3;
  refined.buildings[0].shape = Rectangle{{0.0, 0.0}, 10.0, 10.0, toRadians(-20.0)};
  // Counted from another corner, as a box that turned may be.
  refined.buildings[1].shape = Rectangle{{50.0, 0.0}, 19.0, 10.0, kPi / 2.0};
  const MapChanges changes = changesOf(drawing, refined);
  EXPECT_TRUE(changes.moved.empty());
  ASSERT_EQ(changes.turned.size(), 1U);
  EXPECT_NEAR(toDegrees(changes.turned[0].turned), -20.0, 1e-6);
  ASSERT_EQ(changes.resized.size(), 1U);
  EXPECT_NEAR(changes.resized[0].grown_m(), 9.0, 1e-6);
  EXPECT_NEAR(changes.resized[0].deeper_m, 9.0, 1e-6);
  ASSERT_EQ(changes.kept.size(), 1U);
  EXPECT_EQ(changes.kept[0].building, 2U);
}

TEST(MapChanges, WhatIsFixedStandsAsDrawn) {
  Map drawing;
  drawing.buildings = {at("fixed", 0.0, 0)};
  drawing.buildings[0].fixed = true;
  EXPECT_EQ(changesOf(drawing, drawing).kept.size(), 1U);
  EXPECT_TRUE(changesOf(drawing, drawing).unseen.empty());
}

TEST(MapChanges, ThePolygonThatTurnsIsToldByItsCorners) {
  Building drawn;
  drawn.shape = Polygon{{0, 0}, {24, 0}, {24, 18}, {14, 18}, {14, 8}, {0, 8}};
  Building now = drawn;
  for (Vec2& corner : std::get<Polygon>(now.shape))
    corner = Pose2{3.0, 4.0, toRadians(100.0)}.toOuter(corner);
  const BuildingChange change = changeOf(drawn, now);
  EXPECT_NEAR(toDegrees(change.turned), 100.0, 1e-6);
  EXPECT_NEAR(change.grown_m(), 0.0, 1e-6);
}

TEST(MapChanges, TheErrorIsAgainstTheBuildingOfTheSameId) {
  Map truth;
  truth.buildings = {at("a", 1.0, 0), at("b", 7.0, 0)};
  const TrueMiddles middles(truth);
  EXPECT_DOUBLE_EQ(middles.errorOf(at("b", 4.0, 1)).value(), 3.0);
  EXPECT_FALSE(middles.errorOf(at("c", 4.0, 1)));
}

}  // namespace
}  // namespace handmap
