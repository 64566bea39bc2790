#include "core/outlines/outline_score.h"

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

}  // namespace
}  // namespace handmap
