#include "core/trajectory/scan_features.h"

#include <gtest/gtest.h>

#include "tests/core/trajectory/walled_world.h"

namespace handmap {
namespace {

/// A wall ahead.
std::vector<RangePoint> wallAhead(double sigma_m, double away_m = 8.0) {
  RandomStream random(3);
  std::vector<RangePoint> points;
  for (int i = -60; i <= 60; ++i) {
    const double bearing = toRadians(0.5 * i);
    const double range = away_m / std::cos(bearing) + random.normal(0.0, sigma_m);
    const Vec2 at = range * unitVector(bearing);
    points.push_back({static_cast<float>(at.x()), static_cast<float>(at.y()), 0.0F, 1.0F});
  }
  return points;
}

double shareStraight(const std::vector<ScanPoint>& points) {
  const auto straight =
      std::count_if(points.begin(), points.end(), [](const ScanPoint& p) { return p.straight(); });
  return static_cast<double>(straight) / static_cast<double>(points.size());
}

TEST(ScanFeatures, AWallIsStraightAndFacesTheSensor) {
  const auto points = planarFeatures(wallAhead(0.03));
  ASSERT_EQ(points.size(), 121U);
  EXPECT_GT(shareStraight(points), 0.95);
  for (const ScanPoint& p : points) {
    EXPECT_TRUE(!p.straight() || p.normal.x() < -0.95) << p.at.transpose();
  }
}

TEST(ScanFeatures, TheOrderOfTheReturnsDoesNotMatter) {
  auto scan = wallAhead(0.03);
  const auto points = planarFeatures(scan);
  std::reverse(scan.begin(), scan.end());
  const auto reversed = planarFeatures(scan);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(points[i].at, reversed[i].at);
}

TEST(ScanFeatures, NoiseIsNotStraight) {
  EXPECT_LT(shareStraight(planarFeatures(wallAhead(0.5))), 0.05);
}

TEST(ScanFeatures, OfNoisyRangesMoreReturnsMakeAPiece) {
  const double sigma_m = 0.3;
  ScanNoise noise;
  for (const double away_m : {8.0, 25.0}) {
    std::vector<Vec2> returns;
    for (const RangePoint& p : wallAhead(sigma_m, away_m)) returns.emplace_back(p.x, p.y);
    noise.add(returns);
  }
  const auto points = planarFeatures(wallAhead(sigma_m), noise);
  EXPECT_GT(shareStraight(points), 0.8);
  double squares = 0.0;
  double said = 0.0;
  double count = 0.0;
  for (const ScanPoint& p : points) {
    if (!p.straight()) continue;
    squares += (p.at.x() - 8.0) * (p.at.x() - 8.0);
    said += p.variance;
    ++count;
  }
  EXPECT_LT(std::sqrt(squares / count), 0.5 * sigma_m);
  EXPECT_NEAR(std::sqrt(said / count), sigma_m, 0.3 * sigma_m);
}

TEST(ScanFeatures, OfStereoTheyDoNot) {
  ScanNoise noise;
  for (const auto& [away_m, sigma_m] : {std::pair(8.0, 0.3), std::pair(25.0, 1.2)}) {
    std::vector<Vec2> returns;
    for (const RangePoint& p : wallAhead(sigma_m, away_m)) returns.emplace_back(p.x, p.y);
    noise.add(returns);
  }
  EXPECT_LT(shareStraight(planarFeatures(wallAhead(0.3), noise)), 0.2);
}

TEST(ScanFeatures, APieceEndsAtAGap) {
  std::vector<RangePoint> points = wallAhead(0.0);
  std::erase_if(points, [](const RangePoint& p) { return p.y > 0.0F; });
  for (int i = 1; i <= 60; ++i) {
    const Vec2 at = 12.0 / std::cos(toRadians(0.5 * i)) * unitVector(toRadians(0.5 * i));
    points.push_back({static_cast<float>(at.x()), static_cast<float>(at.y()), 0.0F, 1.0F});
  }
  for (const ScanPoint& p : planarFeatures(points)) {
    ASSERT_TRUE(p.straight());
    EXPECT_LT(p.normal.x(), -0.999) << p.at.transpose();
  }
}

TEST(ScanFeatures, PointsThatStandAreJoinedInThePlane) {
  std::vector<Vec2> points;
  for (int i = 0; i < 200; ++i) points.emplace_back(0.05 * i, 6.0 + 0.02 * (i % 3));
  const auto features = standingFeatures(points);
  EXPECT_LT(features.size(), 40U);
  EXPECT_GT(shareStraight(features), 0.9);
  for (const ScanPoint& p : features) {
    EXPECT_TRUE(!p.straight() || p.normal.y() < -0.95) << p.at.transpose();
  }
}

TEST(ScanFeatures, NothingGivesNothing) {
  EXPECT_TRUE(planarFeatures({}).empty());
  EXPECT_TRUE(standingFeatures({}).empty());
  EXPECT_FALSE(planarFeatures({{1, 1, 0, 1}}).front().straight());
}

}  // namespace
}  // namespace handmap
