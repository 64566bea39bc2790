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

TEST(MapChanges, TheErrorIsAgainstTheBuildingOfTheSameId) {
  Map truth;
  truth.buildings = {at("a", 1.0, 0), at("b", 7.0, 0)};
  const TrueMiddles middles(truth);
  EXPECT_DOUBLE_EQ(middles.errorOf(at("b", 4.0, 1)).value(), 3.0);
  EXPECT_FALSE(middles.errorOf(at("c", 4.0, 1)));
}

}  // namespace
}  // namespace handmap
