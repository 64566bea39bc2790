#include "core/explain/seen_walls.h"

#include <gtest/gtest.h>

#include "core/map/certainty.h"
#include "core/map/map_io.h"

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

/// A robot that passes north of a kiosk and of an L whose notch looks north too, behind a wing.
class WallRaysTest : public testing::Test {
 protected:
  WallRaysTest() {
    drawing_.uncertainty = {2.0, 3.0};
    drawing_.buildings.resize(2);
    drawing_.buildings[0].id = "kiosk";
    drawing_.buildings[1].id = "block";
    drawing_.buildings[0].shape = Rectangle{{0.0, 0.0}, 6.0, 4.0, 0.0};
    drawing_.buildings[1].shape = Polygon{{20, -8}, {44, -8}, {44, 10}, {34, 10}, {34, 0}, {20, 0}};
    refined_ = drawing_;
    for (Building& building : refined_.buildings) {
      building.estimate = Estimate{0.2, 0.2, 0.2, 9};
      setSides(building, {{{0.2, true}, {0.2, true}, {0.2, true}, {0.2, true}}});
    }
  }
  /// Rays down on the upper walls of both, but not into the notch.
  void look() {
    for (double x = -10.0; x < 60.0; x += 1.0) {
      Scan scan;
      Ray ray;
      ray.wall = 1.0F;
      ray.returned = (std::abs(x) < 3.0) || (x > 34.0 && x < 44.0);
      ray.range = static_cast<float>(std::abs(x) < 3.0 ? 18.0 : 10.0);
      scan.rays.push_back(ray);
      rays_.add(outlinesOf(refined_), {x, 20.0, -kPi / 2.0}, scan);
    }
  }
  Map drawing_;
  Map refined_;
  WallRays rays_;
};

TEST_F(WallRaysTest, NoWallIsStatedAsSeenThatNoRayEndedOn) {
  look();
  rays_.state(drawing_, refined_);
  const std::vector<SideEstimate> kiosk = wallsOf(refined_.buildings[0]);
  EXPECT_FALSE(kiosk[0].seen) << "lower";
  EXPECT_DOUBLE_EQ(kiosk[0].sigma, 3.0) << "as well as the drawing knows its sizes";
  EXPECT_FALSE(kiosk[1].seen);
  EXPECT_TRUE(kiosk[2].seen) << "upper";
  EXPECT_DOUBLE_EQ(kiosk[2].sigma, 0.2);
  const std::vector<SideEstimate> block = wallsOf(refined_.buildings[1]);
  EXPECT_TRUE(block[2].seen) << "the wing";
  EXPECT_FALSE(block[4].seen) << "the notch, which looks the same way";
  EXPECT_FALSE(block[0].seen);
}

/// A few of many rays that end by chance where a wall is said to stand do not make it seen.
TEST_F(WallRaysTest, AWallThatRaysGoThroughIsNotSeen) {
  const auto pass = [this](double x, double range) {
    Scan scan;
    Ray ray;
    ray.wall = 1.0F;
    ray.returned = true;
    ray.range = static_cast<float>(range);
    scan.rays.push_back(ray);
    rays_.add(outlinesOf(refined_), {x, 20.0, -kPi / 2.0}, scan);
  };
  for (double x = -2.5; x < 3.0; x += 0.5) pass(x, 22.0);  // to 4 m behind the kiosk's upper wall
  for (double x = -2.5; x < -0.5; x += 0.5) pass(x, 18.0);
  for (double x = 34.5; x < 44.0; x += 0.5) pass(x, 7.0);  // 3 m before the block's wing
  for (double x = 34.5; x < 36.0; x += 0.5) pass(x, 10.0);
  rays_.state(drawing_, refined_);
  EXPECT_FALSE(wallsOf(refined_.buildings[0])[2].seen);
  EXPECT_FALSE(wallsOf(refined_.buildings[1])[2].seen);
  for (double x = 36.0; x < 40.0; x += 0.5) pass(x, 10.0);  // a hedge before a part of it
  setSides(refined_.buildings[1], {{{0.2, true}, {0.2, true}, {0.2, true}, {0.2, true}}});
  rays_.state(drawing_, refined_);
  EXPECT_TRUE(wallsOf(refined_.buildings[1])[2].seen);
}

TEST_F(WallRaysTest, AnObservationSaysWhatItSawOfTheDrawing) {
  refined_.buildings[0].estimate.reset();  // the kiosk was not found yet
  Scan scan;
  for (const double range : {18.0, 18.1, 22.0}) {  // on its upper wall, and through it
    Ray ray;
    ray.wall = 1.0F;
    ray.returned = true;
    ray.range = static_cast<float>(range);
    scan.rays.push_back(ray);
  }
  const Pose2 above{0.0, 20.0, -kPi / 2.0};
  const WallRays::Share unfound = rays_.add(outlinesOf(refined_), above, scan);
  EXPECT_EQ(unfound.walls, 3);
  EXPECT_EQ(unfound.met, 0);
  EXPECT_EQ(unfound.on, 2);
  EXPECT_EQ(unfound.through, 1);
  refined_.buildings[0].estimate = Estimate{0.2, 0.2, 0.2, 9};
  EXPECT_EQ(rays_.add(outlinesOf(refined_), above, scan).met, 2);
}

TEST_F(WallRaysTest, ItIsKeptWithTheMapAndForgottenWithItsShape) {
  look();
  rays_.state(drawing_, refined_);
  const Map read = parseMap(formatMap(refined_), "map");
  EXPECT_EQ(read.buildings[1].seen_walls, refined_.buildings[1].seen_walls);
  EXPECT_TRUE(read.buildings[1].unknown.empty());
  forgetCertainty(refined_.buildings[1]);
  EXPECT_TRUE(refined_.buildings[1].seen_walls.empty());
}

}  // namespace
}  // namespace handmap
