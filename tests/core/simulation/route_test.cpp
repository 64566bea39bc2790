#include "core/simulation/route.h"

#include <gtest/gtest.h>

#include "core/simulation/ray_cast.h"

namespace handmap {
namespace {

Building block(const std::string& id, double x, double y, double width, double depth) {
  Building building;
  building.id = id;
  building.shape = Rectangle{{x, y}, width, depth, 0.0};
  return building;
}

TEST(Route, RoundsCornersAndPointsAlongTheWay) {
  const Route route({{0, 0}, {50, 0}, {50, 0}, {50, 50}});
  EXPECT_DOUBLE_EQ(route.length(), 100.0);
  EXPECT_NEAR(route.poseAt(0.0).x, 0.0, 1e-12);
  EXPECT_NEAR(route.poseAt(0.0).heading, 0.0, 1e-12);
  EXPECT_NEAR(route.poseAt(50.0).heading, kPi / 4.0, 1e-9);
  EXPECT_NEAR(route.poseAt(100.0).heading, kPi / 2.0, 1e-12);
  EXPECT_LT((route.poseAt(50.0).position() - Vec2(50, 0)).norm(), 2.0);
  for (double s = 0.0; s < 100.0; s += 0.5) {
    const Pose2 step = between(route.poseAt(s), route.poseAt(s + 0.5));
    EXPECT_LT(std::abs(step.heading), 0.2) << s;
    EXPECT_LT(std::abs(step.y), 0.1) << s;
  }
}

TEST(Route, ProjectsAndMeasures) {
  const Route route({{0, 0}, {50, 0}, {50, 50}});
  EXPECT_DOUBLE_EQ(route.project({20, 3}).s, 20.0);
  EXPECT_DOUBLE_EQ(route.project({20, 3}).offset, 3.0);
  EXPECT_DOUBLE_EQ(route.project({20, -3}).offset, -3.0);
  EXPECT_DOUBLE_EQ(route.project({54, 30}).s, 80.0);
  EXPECT_DOUBLE_EQ(route.project({54, 30}).offset, -4.0);
  EXPECT_DOUBLE_EQ(route.distanceTo({{10, 5}, {20, 5}, {20, 9}, {10, 9}}), 5.0);
  EXPECT_DOUBLE_EQ(route.distanceTo({{10, -5}, {20, -5}, {20, 9}, {10, 9}}), 0.0);
  EXPECT_DOUBLE_EQ(route.distanceTo({{-100, -100}, {100, -100}, {100, 100}, {-100, 100}}), 0.0);
}

TEST(Route, OfAMapBeginsAtItsStart) {
  Map map;
  EXPECT_FALSE(routeOf(map));
  map.route = {{10, 0}, {20, 0}};
  EXPECT_DOUBLE_EQ(routeOf(map)->length(), 10.0);
  map.start = Pose2{};
  EXPECT_DOUBLE_EQ(routeOf(map)->length(), 20.0);
}

TEST(Route, OfAStartAloneLeadsStraightAhead) {
  Map map;
  map.start = Pose2{};
  EXPECT_FALSE(routeOf(map));
  map.buildings = {block("A", 50, 20, 40, 10), block("B", 80, -20, 40, 10)};
  EXPECT_DOUBLE_EQ(routeOf(map)->length(), 100.0);
  map.buildings.push_back(block("C", 60, 0, 10, 10));
  EXPECT_DOUBLE_EQ(routeOf(map)->length(), 52.0);
}

TEST(Route, NeedsSomewhereToGo) {
  Map map;
  map.route = {{1, 1}, {1, 1}};
  EXPECT_FALSE(routeOf(map));
  map.route = {{1, 1}, {1, 1}, {1, 2}};
  EXPECT_DOUBLE_EQ(routeOf(map)->length(), 1.0);
  map.route.clear();
  map.start = Pose2{};
  map.buildings = {block("Wall", 10, 0, 16, 30)};
  EXPECT_FALSE(routeOf(map));
}

TEST(Route, CutsCornersByLittle) {
  for (const double turn : {0.5, 1.5, 2.5, 3.1}) {
    const Vec2 corner(50, 0);
    const Route route({{0, 0}, corner, corner + 50.0 * unitVector(turn)});
    for (double s = 40.0; s < 60.0; s += 0.25) {
      EXPECT_LT(std::abs(route.project(route.poseAt(s).position()).offset), Route::kCut);
    }
  }
}

TEST(RayCast, MeetsWallsAndCircles) {
  const Vec2 east(1, 0);
  EXPECT_DOUBLE_EQ(rayToSegment({0, 0}, east, {{5, -1}, {5, 1}}), 5.0);
  EXPECT_EQ(rayToSegment({0, 0}, east, {{-5, -1}, {-5, 1}}), kNoHit);
  EXPECT_EQ(rayToSegment({0, 0}, east, {{5, 1}, {5, 2}}), kNoHit);
  EXPECT_EQ(rayToSegment({0, 0}, east, {{5, 0}, {6, 0}}), kNoHit);
}

TEST(RayCast, GoesIntoCirclesAndPolygonsAndOut) {
  const Vec2 east(1, 0);
  const Crossing circle = rayThroughCircle({0, 0}, east, {5, 0}, 2.0);
  EXPECT_DOUBLE_EQ(circle.in, 3.0);
  EXPECT_DOUBLE_EQ(circle.out, 7.0);
  EXPECT_EQ(rayThroughCircle({0, 0}, east, {5, 3}, 2.0).in, kNoHit);
  EXPECT_EQ(rayThroughCircle({0, 0}, east, {-5, 0}, 2.0).in, kNoHit);
  const Crossing box = rayThrough({0, 0}, east, Rectangle{{6, 0.5}, 4.0, 2.0, 0.0}.corners());
  EXPECT_DOUBLE_EQ(box.in, 4.0);
  EXPECT_DOUBLE_EQ(box.out, 8.0);
  EXPECT_EQ(rayThrough({0, 0}, east, Rectangle{{6, 3}, 4.0, 2.0, 0.0}.corners()).in, kNoHit);
  EXPECT_EQ(rayThrough({0, 0}, east, Rectangle{{-6, 0}, 4.0, 2.0, 0.0}.corners()).in, kNoHit);
}

}  // namespace
}  // namespace handmap
