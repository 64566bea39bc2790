#include "core/session/seen_walls.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

/// A robot at the origin that looks up; a house ahead with its front at y = 10, x from -5 to 5, and
/// another one behind it.
class SeenWallsTest : public testing::Test {
 protected:
  SeenWallsTest() {
    for (const double y : {15.0, 40.0}) {
      Building building;
      building.id = y < 20.0 ? "near" : "behind";
      building.shape = Rectangle{{0.0, y}, 10.0, 10.0, 0.0};
      map_.buildings.push_back(building);
    }
    for (int degrees = -60; degrees <= 60; degrees += 2) {
      Ray ray;
      ray.bearing = static_cast<float>(toRadians(degrees));
      const double to_line = 10.0 / std::cos(toRadians(degrees));
      ray.returned = std::abs(to_line * std::sin(toRadians(degrees))) < 3.0;
      ray.range = static_cast<float>(to_line + 0.1);
      ray.wall = 1.0F;
      scan_.rays.push_back(ray);
    }
  }
  Map map_;
  Scan scan_;
  Pose2 robot_{0.0, 0.0, kPi / 2.0};
};

TEST_F(SeenWallsTest, IsThePartThatRaysEndedOn) {
  const std::vector<SeenWall> seen = seenWalls(map_, robot_, scan_);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].building, 0U);
  EXPECT_NEAR(seen[0].piece.a.y(), 10.0, 1e-9);
  EXPECT_NEAR(seen[0].piece.b.y(), 10.0, 1e-9);
  EXPECT_NEAR(seen[0].piece.length(), 6.0, 1.0);
  EXPECT_EQ(seen[0].rays,
            static_cast<int>(std::count_if(scan_.rays.begin(), scan_.rays.end(),
                                           [](const Ray& ray) { return ray.returned; })));
}

TEST_F(SeenWallsTest, NothingIsSeenWhereReturnsAreNotOfWallsOrLieElsewhere) {
  Scan trees = scan_;
  for (Ray& ray : trees.rays) ray.wall = 0.0F;
  EXPECT_TRUE(seenWalls(map_, robot_, trees).empty());
  Scan beyond = scan_;
  for (Ray& ray : beyond.rays) ray.range -= 2.0F;
  EXPECT_TRUE(seenWalls(map_, robot_, beyond).empty());
  EXPECT_TRUE(seenWalls(map_, robot_, Scan{}).empty());
}

TEST_F(SeenWallsTest, AWallIsSeenFromOutsideOnly) {
  const Pose2 inside{0.0, 20.0, -kPi / 2.0};  // looks at the same wall from behind
  EXPECT_TRUE(seenWalls(map_, inside, scan_).empty());
}

}  // namespace
}  // namespace handmap
