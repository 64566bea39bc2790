#include "core/perception/range_walls.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/perception/ground_height.h"

namespace handmap {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Upright points from the ground up to `height` along a line, as dense as a lidar sees it.
void addUpright(std::vector<RangePoint>& points, Vec2 a, Vec2 b, double height, double slope) {
  for (double t = 0.0; t <= 1.0; t += 0.04 / (b - a).norm()) {
    const Vec2 p = a + t * (b - a);
    for (double z = 0.1; z <= height; z += 0.2) {
      points.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()),
                        static_cast<float>(slope * p.x() + z), 1.0F});
    }
  }
}

std::vector<RangePoint> ground(double slope) {
  std::vector<RangePoint> points;
  for (float x = -38.0F; x <= 38.0F; x += 0.4F) {
    for (float y = -9.0F; y <= 9.0F; y += 0.4F) {
      points.push_back({x, y, static_cast<float>(slope) * x, 1.0F});
    }
  }
  return points;
}

bool near(const WallPoint& point, double x) {
  return std::abs(static_cast<double>(point.x) - x) < 0.05;
}

TEST(RangeWalls, TakesAPlanarScanAsItIs) {
  const auto walls = RangeWalls(40.0, {})({{5, 1, 0.2F, 1.0F}, {0, -7, 0.3F, 0.4F}}, {});
  ASSERT_EQ(walls.size(), 2u);
  EXPECT_EQ(walls[0].x, 5.0F);
  EXPECT_EQ(walls[1].y, -7.0F);
  EXPECT_EQ(walls[1].weight, 0.4F);
  EXPECT_GT(walls[1].sigma, 0.0F);
}

TEST(RangeWalls, DropsWhatIsOutOfRangeOrNotANumber) {
  const std::vector<RangePoint> points{{0.5F, 0, 0, 1},     {41, 0, 0, 1},   {kNan, 0, 0, 1},
                                       {5, 0, kNan, 1},     {5, 0, 0, kNan}, {5, 0, 0, 0},
                                       {INFINITY, 0, 0, 1}, {39, 0, 0, 1}};
  const auto walls = RangeWalls(40.0, {})(points, {});
  ASSERT_EQ(walls.size(), 1u);
  EXPECT_EQ(walls[0].x, 39.0F);
  EXPECT_TRUE(RangeWalls(40.0, {})({}, {}).empty());
}

TEST(RangeWalls, KeepsWallsAndLeavesOutTheLow) {
  std::vector<RangePoint> points = ground(0.0);
  addUpright(points, {12, -4}, {12, 4}, 3.0, 0.0);  // a house
  addUpright(points, {6, 2}, {6, 4}, 1.6, 0.0);     // a car
  for (const WallPoint& wall : RangeWalls(40.0, {})(points, {})) EXPECT_TRUE(near(wall, 12.0));
  const auto walls = RangeWalls(40.0, {})(points, {});
  EXPECT_GE(walls.size(), 80u);           // every 0.1 m of it
  EXPECT_LE(walls.size(), 3u * 2 * 81u);  // and no more than three points a spot
}

TEST(RangeWalls, FollowsTheStreetUpAndDown) {
  for (const double slope : {-0.08, 0.08}) {
    std::vector<RangePoint> points = ground(slope);
    addUpright(points, {30, -4}, {30, 4}, 3.0, slope);
    addUpright(points, {25, 2}, {25, 4}, 1.6, slope);
    addUpright(points, {-25, 2}, {-25, 4}, 1.6, slope);
    const auto walls = RangeWalls(40.0, {})(points, {});
    EXPECT_GE(walls.size(), 80u);
    EXPECT_TRUE(std::all_of(walls.begin(), walls.end(), [](const auto& w) { return near(w, 30); }))
        << "slope " << slope;
  }
}

/// What a lidar that looks 2° upwards sees of a wall along y = 8 of that height, and of a house
/// behind it where it looks over.
std::vector<RangePoint> lookingUpALittle(double robot_x, double wall_height) {
  constexpr double kSensor = 1.7;
  std::vector<RangePoint> points = ground(0.0);
  for (double x = -6.0; x <= 6.0; x += 0.2) {
    for (double elevation = -8.0; elevation < 2.01; elevation += 0.4) {
      const double slope = std::tan(toRadians(elevation));
      const Vec2 direction = Vec2(x - robot_x, 8.0).normalized();
      double range = Vec2(x - robot_x, 8.0).norm();
      if (kSensor + range * slope > wall_height) range += 6.0;
      points.push_back({static_cast<float>(range * direction.x()),
                        static_cast<float>(range * direction.y()),
                        static_cast<float>(kSensor + range * slope), 1.0F});
    }
  }
  return points;
}

TEST(RangeWalls, AFenceIsToldFromAHouseOnceItWasLookedOver) {
  for (const double height : {2.1, 6.0}) {
    RangeWalls walls(40.0, {});
    const auto on_the_wall = [&](double robot_x) {
      const auto found = walls(lookingUpALittle(robot_x, height), {robot_x, 0.0, 0.0});
      return std::count_if(found.begin(), found.end(), [](const WallPoint& p) {
        return std::abs(static_cast<double>(p.y) - 8.0) < 0.1;
      });
    };
    const auto near_by_at_first = RangeWalls(40.0, {})(lookingUpALittle(0.0, height), {}).size();
    EXPECT_GT(near_by_at_first, 50u) << "from near by both are walls";
    on_the_wall(-25.0);
    on_the_wall(-20.0);
    if (height > 3.0) {
      EXPECT_GT(on_the_wall(0.0), 50);
    } else {
      EXPECT_LT(on_the_wall(0.0), 20);
    }
  }
}

TEST(GroundHeight, IgnoresStraysBelowAndRoofsAbove) {
  std::vector<RangePoint> points = ground(0.0);
  points.push_back({10, 0, -3, 1});
  points.push_back({10.2F, 0, -5, 1});
  for (float y = 20.0F; y < 30.0F; y += 0.2F) points.push_back({0, y, 7, 1});
  const GroundHeight height(points, 40.0F);
  EXPECT_NEAR(height.at(10, 0), 0.0F, 1e-5);
  EXPECT_LT(height.at(0, 25), 3.0F);
  EXPECT_EQ(height.at(0, -35), 0.0F);  // nothing was seen there
}

}  // namespace
}  // namespace handmap
