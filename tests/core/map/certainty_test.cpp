#include "core/map/certainty.h"

#include <gtest/gtest.h>

#include "core/map/map_io.h"

namespace handmap {
namespace {

Building box(double heading) {
  Building building;
  building.id = "N1";
  building.shape = Rectangle{{0.0, 0.0}, 20.0, 10.0, heading};
  building.estimate = Estimate{0.1, 0.3, 0.8, 4};
  return building;
}

TEST(Certainty, WithoutSidesTheCentreAndTheWidthTell) {
  const Sides sides = sidesOf(box(kPi / 2.0));
  EXPECT_NEAR(sides[0].sigma, 0.5, 1e-9);  // of a centre off by 0.3 m and a width by 0.8 m
  EXPECT_NEAR(sides[1].sigma, 0.1 * std::sqrt(2.0), 1e-9);
  EXPECT_EQ(sides[2], sides[0]);
  EXPECT_TRUE(sides[3].seen);
  Building unseen = box(0.0);
  unseen.estimate->observations = 0;
  EXPECT_FALSE(sidesOf(unseen)[0].seen);
  unseen.estimate.reset();
  EXPECT_EQ(sidesOf(unseen), Sides());
}

TEST(Certainty, WhatTheRunToldIsKeptInTheFile) {
  const Sides told = {{{0.125, true}, {0.5, true}, {2.25, false}, {0.25, true}}};
  Map map;
  map.buildings = {box(0.3)};
  setSides(map.buildings[0], told);
  setDoubt(map.buildings[0], 0.25);
  const Map read = parseMap(formatMap(map), "text");
  EXPECT_EQ(sidesOf(read.buildings[0]), told);
  EXPECT_EQ(doubtOf(read.buildings[0]), 0.25);
  Building forgotten = read.buildings[0];
  forgetCertainty(forgotten);
  EXPECT_FALSE(forgotten.sides || forgotten.doubt);
  EXPECT_TRUE(forgotten.unknown.empty());
  EXPECT_EQ(doubtOf(forgotten), 0.0);
}

TEST(Certainty, NonsenseInTheFileIsAsIfItWereNotThereAndStays) {
  Map map;
  map.buildings = {box(0.0)};
  const Sides usual = sidesOf(map.buildings[0]);
  for (const char* sigmas : {"[1,2,3]", "[1,2,3,-4]", "[1,2,3,\"x\"]", "7", "{\"a\":1}", "null"}) {
    map.buildings[0].unknown = {{"wall_sigma_m", sigmas}, {"walls_seen", "[true,true,true,true]"}};
    const Map read = parseMap(formatMap(map), "text");
    EXPECT_EQ(sidesOf(read.buildings[0]), usual) << sigmas;
    EXPECT_EQ(read, map);
  }
}

TEST(Certainty, EachWallHasTheSideThatItFaces) {
  Building building = box(0.0);
  setSides(building, {{{1.0, true}, {2.0, true}, {3.0, false}, {4.0, true}}});
  const Polygon footprint = building.footprint();
  const auto walls = wallsOf(building);
  ASSERT_EQ(walls.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 middle = 0.5 * (footprint[i] + footprint[(i + 1) % 4]);
    const double expected = middle.x() > 5.0    ? 1.0
                            : middle.y() > 2.0  ? 2.0
                            : middle.x() < -5.0 ? 3.0
                                                : 4.0;
    EXPECT_EQ(walls[i].sigma, expected);
    EXPECT_EQ(walls[i].seen, expected != 3.0);
  }
}

TEST(Certainty, AnLShapeHasTwoWallsOnTwoOfItsSides) {
  Building building = box(0.0);
  building.shape = Polygon{{0, 0}, {20, 0}, {20, 5}, {8, 5}, {8, 12}, {0, 12}};
  setSides(building, {{{1.0, true}, {2.0, true}, {3.0, true}, {4.0, true}}});
  std::vector<double> sigmas;
  for (const SideEstimate& wall : wallsOf(building)) sigmas.push_back(wall.sigma);
  EXPECT_EQ(sigmas, (std::vector<double>{4, 1, 2, 1, 2, 3}));
}

}  // namespace
}  // namespace handmap
