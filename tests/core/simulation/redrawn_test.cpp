#include "core/simulation/redrawn.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

/// A house with an annex 3 m deep, and a shed.
Map yard() {
  Map map;
  Building house;
  house.id = "house";
  house.shape = Polygon{{0, 0}, {20, 0}, {20, 12}, {14, 12}, {14, 15}, {8, 15}, {8, 12}, {0, 12}};
  Building shed;
  shed.id = "shed";
  shed.shape = Rectangle{{40, 5}, 6.0, 4.0, 0.0};
  map.buildings = {house, shed};
  return map;
}

TEST(Redrawn, LeavesOutWhatIsSmall) {
  const Map truth = yard();
  const Map drawn = redrawn(truth, {.simplify_m = 3.5}, 1);
  const Polygon outline = drawn.buildings[0].footprint();
  EXPECT_LT(outline.size(), 8U);
  EXPECT_GE(outline.size(), 4U);
  EXPECT_GT(intersectionOverUnion(outline, truth.buildings[0].footprint()), 0.8);
  EXPECT_EQ(drawn.buildings[1], truth.buildings[1]);
}

TEST(Redrawn, KeepsWhatIsLarge) {
  const Map truth = yard();
  EXPECT_EQ(redrawn(truth, {.simplify_m = 0.5}, 1).buildings, truth.buildings);
  EXPECT_EQ(redrawn(truth, {}, 1).buildings, truth.buildings);
}

TEST(Redrawn, MovesEveryCornerByItself) {
  const Map truth = yard();
  const Map drawn = redrawn(truth, {.corners_m = 0.5}, 1);
  EXPECT_EQ(drawn.buildings, redrawn(truth, {.corners_m = 0.5}, 1).buildings);
  EXPECT_NE(drawn.buildings, redrawn(truth, {.corners_m = 0.5}, 2).buildings);
  for (std::size_t i = 0; i < truth.buildings.size(); ++i) {
    const Polygon before = truth.buildings[i].footprint();
    const Polygon after = drawn.buildings[i].footprint();
    ASSERT_EQ(after.size(), before.size());
    EXPECT_TRUE(isSimple(after));
    for (std::size_t k = 0; k < after.size(); ++k) EXPECT_NE(after[k], before[k]);
  }
}

TEST(Redrawn, StaysSimpleHoweverFarCornersMove) {
  const Map drawn = redrawn(yard(), {.corners_m = 8.0}, 3);
  for (const Building& building : drawn.buildings) EXPECT_TRUE(isSimple(building.footprint()));
}

TEST(Redrawn, LeavesFixedBuildingsAlone) {
  Map truth = yard();
  truth.buildings[0].fixed = true;
  EXPECT_EQ(redrawn(truth, {2.0, 5.0}, 1).buildings[0], truth.buildings[0]);
}

}  // namespace
}  // namespace handmap
