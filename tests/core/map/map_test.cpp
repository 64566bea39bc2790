#include "core/map/map.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

Building polygonBuilding(const Pose2& frame) {
  Building building;
  building.id = "P";
  Polygon corners = {{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 8}, {0, 8}};
  for (Vec2& corner : corners) corner = frame.toOuter(corner);
  building.shape = corners;
  return building;
}

TEST(Building, RectangleIsItsOwnBoxAndBecomesTheTarget) {
  Building building;
  building.id = "R";
  building.name = "Library";
  const Rectangle rectangle{{10, 20}, 8, 4, 0.5};
  building.shape = rectangle;
  EXPECT_EQ(building.box(), rectangle);
  EXPECT_EQ(building.footprint(), rectangle.corners());
  const Rectangle target{{11, 18}, 9, 5, 0.6};
  const Building fitted = building.fitted(target);
  EXPECT_EQ(std::get<Rectangle>(fitted.shape), target);
  EXPECT_EQ(fitted.id, "R");
  EXPECT_EQ(fitted.name, "Library");
}

TEST(Building, PolygonHasTheBoxAlongItsWalls) {
  const Building building = polygonBuilding({5, -3, 0.3});
  const Rectangle box = building.box();
  EXPECT_NEAR(box.width, 10.0, 1e-9);
  EXPECT_NEAR(box.depth, 8.0, 1e-9);
  EXPECT_NEAR(box.heading, 0.3, 1e-9);
  EXPECT_TRUE(box.centre.isApprox(Pose2{5, -3, 0.3}.toOuter({5, 4})));
}

TEST(Building, PolygonMovesTurnsAndStretchesAsAWhole) {
  const Building building = polygonBuilding({5, -3, 0.3});
  const Rectangle target{{50, 60}, 20, 4, 0.5};
  const auto corners = std::get<Polygon>(building.fitted(target).shape);
  const Pose2 frame{50, 60, 0.5};
  ASSERT_EQ(corners.size(), 6u);
  EXPECT_TRUE(corners[0].isApprox(frame.toOuter({-10, -2}), 1e-9));
  EXPECT_TRUE(corners[2].isApprox(frame.toOuter({10, 0}), 1e-9));
  EXPECT_TRUE(corners[3].isApprox(frame.toOuter({-2, 0}), 1e-9));
  EXPECT_TRUE(isSimple(corners));
  EXPECT_GT(signedArea(corners), 0.0);
}

TEST(Building, FittedToItsOwnBoxStays) {
  const Building building = polygonBuilding({5, -3, 1.2});
  const auto before = building.footprint();
  const auto after = building.fitted(building.box()).footprint();
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_TRUE(after[i].isApprox(before[i], 1e-12));
  }
}

TEST(Map, FindsBuildingsAndTheirUncertainty) {
  Map map;
  map.uncertainty = {2.0, 1.0};
  map.buildings = {polygonBuilding({}), polygonBuilding({})};
  map.buildings[0].id = "A";
  map.buildings[1].id = "B";
  map.buildings[1].uncertainty = Uncertainty{0.5, 0.25};
  EXPECT_EQ(map.find("B"), &map.buildings[1]);
  EXPECT_EQ(map.find("C"), nullptr);
  EXPECT_EQ(map.uncertaintyOf(map.buildings[0]), (Uncertainty{2.0, 1.0}));
  EXPECT_EQ(map.uncertaintyOf(map.buildings[1]), (Uncertainty{0.5, 0.25}));
}

}  // namespace
}  // namespace handmap
