#include "core/outlines/refinement.h"

#include <gtest/gtest.h>

#include "tests/core/outlines/drive.h"

namespace handmap {
namespace {

Map drawingOf(const Rectangle& box, double sigma_m) {
  Map map;
  map.start = Pose2{};
  map.uncertainty = {sigma_m, sigma_m};
  Building building;
  building.id = "A";
  building.shape = box;
  map.buildings.push_back(building);
  return map;
}

const Rectangle kDrawn{{20.0, 12.0}, 14.0, 8.0, 0.0};

TEST(Refinement, KeepsWhatWasFoundWhereOutlinesCannotBeFitted) {
  const Map drawing = drawingOf(kDrawn, 0.5);  // sure of itself
  Map found = drawing;
  found.buildings[0].shape = Rectangle{{20.6, 12.3}, 14.0, 8.0, 0.0};
  found.buildings[0].estimate = Estimate{0.1, 0.1, 0.1, 12};
  const Drive drive = drivePast({});
  const auto map =
      refine(drawing, FoundMap{found, DrawingMotion{}}, placeRays(drive.seen, drive.way), 40.0, 1);
  ASSERT_TRUE(map);
  EXPECT_NEAR(map->map.buildings[0].box().centre.x(), 20.6, 1e-6);
}

TEST(Refinement, SaysNoMoreOfADrawnPlaceThanTheDrawing) {
  // Found 60 m from all walls, drawn where there is nothing to tell it either.
  const Rectangle far{{30.0, -150.0}, 14.0, 8.0, 0.0};
  const Map drawing = drawingOf(far, 0.5);
  Map found = drawing;
  found.buildings[0].estimate = Estimate{0.1, 0.1, 0.1, 12};
  const Drive drive = drivePast({kDrawn.corners()});
  const auto map =
      refine(drawing, FoundMap{found, DrawingMotion{}}, placeRays(drive.seen, drive.way), 40.0, 1);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->map.buildings[0].estimate, (Estimate{0.5, 0.5, 0.5, 0}));
}

TEST(Refinement, KeepsTheDrawnDepthOfACrookedOutline) {
  // The smallest box around the one lies along its gable, that around the other along its front.
  const Polygon drawn = {{20.1, 6.4}, {41.3, 6.5}, {42.3, 18.1}, {20.9, 18.4}};
  const Polygon shallow = {{22.8, 7.7}, {39.4, 8.0}, {39.9, 16.6}, {23.3, 16.6}};
  Map drawing = drawingOf(kDrawn, 3.0);
  drawing.buildings[0].shape = drawn;
  Map found = drawing;
  found.buildings[0].shape = shallow;
  found.buildings[0].estimate = Estimate{0.1, 0.1, 0.1, 12};
  const Drive drive = drivePast({Rectangle{{31.0, 12.7}, 17.0, 10.0, 0.0}.corners()});
  const auto refined =
      refine(drawing, FoundMap{found, DrawingMotion{}}, placeRays(drive.seen, drive.way), 40.0, 1);
  ASSERT_TRUE(refined);
  const Bounds bounds = boundsOf(refined->map.buildings[0].footprint());
  EXPECT_NEAR(bounds.low.y(), 7.7, 0.4);
  EXPECT_NEAR(bounds.high.y() - bounds.low.y(), 12.0, 3.0);
}

/// What stands beside it hides how far its gables go on behind what was seen of them.
TEST(Refinement, KeepsTheDrawnDepthWhereRaysTellNothingOfTheRear) {
  const Rectangle house{{31.0, 12.7}, 17.0, 10.0, 0.0};
  Map drawing = drawingOf({{32.0, 14.0}, 17.0, 10.0, 0.0}, 3.0);
  Map found = drawing;
  found.buildings[0].shape = Rectangle{{31.0, 9.6}, 17.0, 3.8, 0.0};
  found.buildings[0].estimate = Estimate{0.1, 0.1, 0.1, 12};
  Sides sides;
  sides.fill({0.3, true});
  setSides(found.buildings[0], sides);
  const Polygon west = Rectangle{{21.5, 14.6}, 1.6, 6.2, 0.0}.corners();
  const Polygon east = Rectangle{{40.5, 14.6}, 1.6, 6.2, 0.0}.corners();
  const Drive drive = drivePast({house.corners(), west, east});
  const auto refined =
      refine(drawing, FoundMap{found, DrawingMotion{}}, placeRays(drive.seen, drive.way), 40.0, 1);
  ASSERT_TRUE(refined);
  const Bounds bounds = boundsOf(refined->map.buildings[0].footprint());
  EXPECT_NEAR(bounds.low.y(), 7.7, 0.4);
  EXPECT_NEAR(bounds.high.y(), 17.7, 1.0);
}

TEST(Refinement, WhatNobodySawStaysAsDrawnWhereTheWayIsToldWithoutTheDrawing) {
  // Ten houses are seen, four of them where they are drawn but for a turn of the way.
  const double turn = toRadians(1.5);
  Map drawing = drawingOf({{30.0, -150.0}, 14.0, 8.0, 0.0}, 3.0);
  std::vector<Polygon> houses;
  for (int i = 0; i < 10; ++i) {
    Building house = drawing.buildings[0];
    house.id = std::string(1, static_cast<char>('B' + i));
    const int column = i / 2;
    house.shape = Rectangle{{15.0 * column, i % 2 == 0 ? -11.0 : 11.0}, 9.0, 7.0, 0.0};
    drawing.buildings.push_back(house);
    Polygon outline = house.footprint();
    const Vec2 own = i < 4 ? Vec2(0.0, 0.0) : Vec2(i % 2 == 0 ? 3.0 : -3.0, 2.0);
    for (Vec2& corner : outline) corner = Pose2{0.0, 0.0, turn}.toOuter(corner) + own;
    houses.push_back(outline);
  }
  const Drive drive = drivePast(houses);
  const auto refined = refine(drawing, std::nullopt, placeRays(drive.seen, drive.way), 40.0, 1);
  ASSERT_TRUE(refined);
  EXPECT_GT(std::abs(refined->motion.heading), 0.2 * turn);
  EXPECT_LT(refined->right, 0.45);
  EXPECT_EQ(refined->map.buildings[0].shape, drawing.buildings[0].shape);
}

TEST(Refinement, LeavesADrawingThatIsRightAsItIs) {
  Map drawing = drawingOf(kDrawn, 3.0);
  std::vector<Polygon> houses;
  for (int i = 0; i < 4; ++i) {
    Building house = drawing.buildings[0];
    house.id = std::string(1, static_cast<char>('B' + i));
    house.shape = Rectangle{{15.0 * i + 5.0, -11.0}, 9.0, 7.0, 0.0};
    drawing.buildings.push_back(house);
  }
  for (const Building& house : drawing.buildings) houses.push_back(house.footprint());
  const Drive drive = drivePast(houses);
  const PlacedRays placed = placeRays(drive.seen, drive.way);
  EXPECT_EQ(supportOf(drawing, placed, 40.0), 1.0);
  const auto refined = refine(drawing, std::nullopt, placed, 40.0, 1);
  ASSERT_TRUE(refined);
  EXPECT_GT(refined->right, 0.9);
  for (std::size_t b = 0; b < drawing.buildings.size(); ++b) {
    EXPECT_EQ(refined->map.buildings[b].shape, drawing.buildings[b].shape) << b;
  }
}

TEST(Refinement, DoubtsWhatIsLookedThroughAndNothingElse) {
  const Rectangle on_the_way{{40.0, 2.0}, 10.0, 6.0, 0.0};
  const Rectangle not_seen{{30.0, -150.0}, 14.0, 8.0, 0.0};
  const Drive drive = drivePast({kDrawn.corners()});
  for (const bool is_found : {false, true}) {
    Map drawing = drawingOf(kDrawn, 1.5);
    Map found = drawing;
    found.buildings[0].estimate = Estimate{0.1, 0.1, 0.1, 12};
    for (const Rectangle& box : {on_the_way, not_seen}) {
      drawing.buildings.push_back(drawingOf(box, 1.5).buildings[0]);
      found.buildings.push_back(drawing.buildings.back());
    }
    const auto refined =
        refine(drawing, is_found ? std::optional(FoundMap{found, DrawingMotion{}}) : std::nullopt,
               placeRays(drive.seen, drive.way), 40.0, 1);
    ASSERT_TRUE(refined);
    EXPECT_FALSE(refined->map.buildings[0].doubt) << is_found;
    EXPECT_GT(refined->map.buildings[1].doubt.value_or(0.0), 0.5) << is_found;
    EXPECT_FALSE(refined->map.buildings[2].doubt) << is_found;
  }
}

TEST(Refinement, SaysHowFarRaysSpeakForADrawing) {
  Map drawing = drawingOf(kDrawn, 3.0);
  const Drive drive = drivePast({kDrawn.corners()});
  const PlacedRays placed = placeRays(drive.seen, drive.way);
  EXPECT_EQ(supportOf(drawing, placed, 40.0), 1.0);
  drawing.buildings[0].shape = Rectangle{{20.0, 8.0}, 14.0, 8.0, 0.0};  // before the wall
  EXPECT_EQ(supportOf(drawing, placed, 40.0), 0.0);
}

}  // namespace
}  // namespace handmap
