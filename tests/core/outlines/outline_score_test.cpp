#include "core/outlines/outline_score.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "core/outlines/constants.h"
#include "tests/core/outlines/drive.h"

namespace handmap {
namespace {

using namespace outlines;

const Polygon kScoredHouse = Rectangle{{20.0, 12.0}, 14.0, 8.0, 0.0}.corners();

class OutlineScore : public testing::Test {
 protected:
  Drive drive_ = drivePast({kScoredHouse});
  PlacedRays placed_ = placeRays(drive_.seen, drive_.way);
  OutlineScorer scorer_{placed_, 40.0, {}, kNobody, {20.0, 12.0}, 20.0};
};

TEST_F(OutlineScore, IsGreatestWhereTheHouseIs) {
  const double there = scorer_(kScoredHouse, 0.15);
  EXPECT_GT(there, 10.0);
  for (const Vec2& by : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
    EXPECT_LT(scorer_(moved(kScoredHouse, by), 0.15), there);
  }
}

TEST_F(OutlineScore, SpeaksAgainstAHouseThatRaysGoThrough) {
  EXPECT_LT(scorer_(moved(kScoredHouse, {0.0, -5.0}), 0.15), 0.0);
}

TEST_F(OutlineScore, HasNoRobotInAHouse) {
  EXPECT_LT(scorer_(moved(kScoredHouse, {0.0, -12.0}), 0.15), -100.0);
}

TEST_F(OutlineScore, IsThatOfItsWalls) {
  for (const double nearer : {0.0, 3.0}) {
    const Polygon outline = moved(kScoredHouse, {0.0, -nearer});
    const std::vector<double> walls = scorer_.ofWalls(outline, 0.15);
    ASSERT_EQ(walls.size(), 4U);
    EXPECT_NEAR(std::accumulate(walls.begin(), walls.end(), 0.0), scorer_(outline, 0.15), 1e-6);
    EXPECT_EQ(std::ranges::min(walls) < -1.0, nearer > 0.0);
  }
}

TEST_F(OutlineScore, GivesReturnsToTheWallsTheyAreFrom) {
  const std::vector<double> returns = scorer_.returnsOf(kScoredHouse, 0.3);
  ASSERT_EQ(returns.size(), 4U);
  // Wall i ends at corner i; corners from the low left one on: left, front, right, back.
  std::vector<double> sorted = returns;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(sorted[0], 0.0);  // the back
  EXPECT_GT(sorted[3], 2.0);  // the front
}

TEST_F(OutlineScore, TakesNoCreditForReturnsOfOthers) {
  RayOwners owners(placed_.rays.size(), kNobody);
  for (const auto& [ray, ratio] : scorer_.standingFor(kScoredHouse, 0.5)) owners[ray] = 3;
  const OutlineScorer others(placed_, 40.0, owners, 1, {20.0, 12.0}, 20.0);
  const OutlineScorer its_own(placed_, 40.0, owners, 3, {20.0, 12.0}, 20.0);
  EXPECT_LE(others(kScoredHouse, 0.15), 0.0);
  EXPECT_DOUBLE_EQ(its_own(kScoredHouse, 0.15), scorer_(kScoredHouse, 0.15));
}

TEST_F(OutlineScore, AsksEachRayThatMeetsAWallFirst) {
  const Polygon wings = {{12.0, 8.0},  {28.0, 8.0},  {28.0, 16.0},
                         {22.0, 16.0}, {22.0, 11.0}, {12.0, 11.0}};
  std::vector<std::size_t> meet;
  for (std::size_t i = 0; i < placed_.rays.size(); ++i) {
    const PlacedRay& ray = placed_.rays[i];
    if (ray.echo != Echo::Tall) continue;
    const double there = distanceAlong({ray.x, ray.y}, {ray.dx, ray.dy}, wings);
    if (std::abs(there - static_cast<double>(ray.range)) < 4.0) meet.push_back(i);
  }
  std::vector<std::size_t> asked;
  for (const auto& [ray, ratio] : scorer_.standingFor(wings, 4.0)) {
    const PlacedRay& r = placed_.rays[ray];
    const double there = distanceAlong({r.x, r.y}, {r.dx, r.dy}, wings);
    // Across the wall it is nearer than along the ray.
    if (std::abs(there - static_cast<double>(r.range)) < 4.0) asked.push_back(ray);
  }
  ASSERT_GT(meet.size(), 500U);
  EXPECT_EQ(asked, meet);
}

TEST_F(OutlineScore, OfFewRaysIsNearlyThatOfAll) {
  const double all = scorer_(kScoredHouse, 0.3);
  EXPECT_NEAR(scorer_.thinned(1000)(kScoredHouse, 0.3), all, 0.2 * all);
  EXPECT_DOUBLE_EQ(scorer_.thinned(1'000'000)(kScoredHouse, 0.3), all);
}

}  // namespace
}  // namespace handmap
