#include "core/perception/local_map.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "tests/core/base/expect_error.h"

namespace handmap {
namespace {

using test::expectBadInput;
using Walls = std::vector<WallPoint>;

constexpr double kRange_m = 20.0;

WallPoint at(double x, double y, double sigma = 0.0, double weight = 1.0) {
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(sigma),
          static_cast<float>(weight)};
}

LocalMapOptions sharp() {
  LocalMapOptions options;
  options.smoothing_sigma_m = 0.0;
  options.saturation_votes = 1.0;
  return options;
}

double sum(const LocalMap& map) { return cv::sum(map.cells())[0]; }

double highest(const LocalMap& map) {
  double value = 0.0;
  cv::minMaxLoc(map.cells(), nullptr, &value);
  return value;
}

/// A straight wall at x with `votes` in each cell.
Walls wallAt(double x, int votes) {
  Walls walls;
  for (int i = 0; i < votes; ++i) {
    for (double y = -3.05; y < 3.0; y += 0.1) walls.push_back(at(x, y));
  }
  return walls;
}

TEST(LocalMap, HasItsCellsInTheRobotFrame) {
  const LocalMap map = LocalMapBuilder(kRange_m, sharp()).add({3, 4, 1}, false, {at(5.05, -2.05)});
  EXPECT_EQ(map.cells().size(), cv::Size(400, 400));
  EXPECT_EQ(map.at(5.05, -2.05), 1.0F);
  EXPECT_EQ(map.cells()(map.columnOf(-2.05), map.columnOf(5.05)), 1.0F);
  EXPECT_EQ(sum(map), 1.0);
}

TEST(LocalMap, DropsWhatLiesBeyondTheGrid) {
  const LocalMap map = LocalMapBuilder(kRange_m, {})
                           .add({}, false, {at(20.5, 0), at(-21, 0), at(0, 20.5), at(0, -30)});
  EXPECT_EQ(sum(map), 0.0);
}

TEST(LocalMap, SmoothsAndStaysBetweenZeroAndOne) {
  LocalMapBuilder builder(kRange_m, {});
  const LocalMap map = builder.add({}, true, wallAt(4.05, 100));
  EXPECT_GT(map.at(4.05, 0), map.at(4.25, 0));
  EXPECT_GT(map.at(4.25, 0), map.at(4.45, 0));
  EXPECT_NEAR(map.at(4.25, 0), map.at(3.85, 0), 1e-6);
  const LocalMap thick = builder.add({}, true, [] {
    Walls walls;
    for (int i = 0; i < 8; ++i) {
      const Walls layer = wallAt(4.05 + 0.1 * i, 5);
      walls.insert(walls.end(), layer.begin(), layer.end());
    }
    return walls;
  }());
  EXPECT_EQ(highest(thick), 1.0);
}

TEST(LocalMap, SaturatesSoThatDenseWallsDoNotDwarfOthers) {
  LocalMapBuilder builder(kRange_m, {});
  const double few = highest(builder.add({}, true, wallAt(4.05, 1)));
  const double enough = highest(builder.add({}, true, wallAt(4.05, 3)));
  const double many = highest(builder.add({}, true, wallAt(4.05, 100)));
  EXPECT_NEAR(enough, 3.0 * few, 1e-6);
  EXPECT_EQ(many, enough);
}

TEST(LocalMap, SpreadsAVoteAlongItsRay) {
  const LocalMap map = LocalMapBuilder(kRange_m, sharp()).add({}, true, {at(10.05, 0.05, 0.5)});
  EXPECT_NEAR(sum(map), 1.0, 1e-5);
  EXPECT_GT(map.at(9.55, 0.05), 0.4F * map.at(10.05, 0.05));
  EXPECT_LT(map.at(9.55, 0.05), map.at(10.05, 0.05));
  EXPECT_EQ(map.at(10.05, 0.25), 0.0F);
}

TEST(LocalMap, PlacesEarlierScansByOdometry) {
  LocalMapBuilder builder(kRange_m, sharp());
  // The wall point at (10.05, 2.05) of the odometry frame, seen from two poses.
  builder.add({0, 0, 0}, false, {at(10.05, 2.05)});
  const LocalMap turned = builder.add({5, 0, kPi / 2}, false, {});
  EXPECT_EQ(turned.at(2.05, -5.05), 1.0F);
  EXPECT_EQ(sum(turned), 1.0);
}

TEST(LocalMap, ForgetsAfterTheLengthOfThePath) {
  LocalMapOptions options = sharp();
  options.path_m = 6.0;
  LocalMapBuilder builder(kRange_m, options);
  builder.add({0, 0, 0}, false, {at(5.05, 1.05)});
  EXPECT_EQ(sum(builder.add({3, 0, 0}, false, {})), 1.0);
  EXPECT_EQ(sum(builder.add({6, 0, 0}, false, {})), 1.0);
  // Back near the start: what counts is the way travelled.
  EXPECT_EQ(sum(builder.add({5, 0, 0}, false, {})), 0.0);
}

TEST(LocalMap, AStandingRobotUsesThatStopAlone) {
  LocalMapBuilder builder(kRange_m, sharp());
  builder.add({0, 0, 0}, true, {at(5.05, 1.05)});
  const LocalMap map = builder.add({1, 0, 0}, true, {at(7.05, 1.05)});
  EXPECT_EQ(map.at(7.05, 1.05), 1.0F);
  EXPECT_EQ(sum(map), 1.0);
}

TEST(LocalMap, AWaitingRobotDoesNotPileUpVotes) {
  LocalMapOptions options = sharp();
  options.saturation_votes = 1000.0;
  LocalMapBuilder builder(kRange_m, options);
  double waiting = 0.0;
  for (int i = 0; i < 50; ++i) waiting = sum(builder.add({0, 0, 0}, false, {at(5.05, 1.05)}));
  EXPECT_NEAR(waiting, 2.0 / 1000.0, 1e-6);
  // A robot that creeps is not one that waits.
  double creeping = 0.0;
  for (int i = 1; i <= 50; ++i) {
    creeping = sum(builder.add({0.06 * i, 0, 0}, false, {at(5.05 - 0.06 * i, 1.05)}));
  }
  EXPECT_GT(creeping, 20.0 / 1000.0);
}

TEST(LocalMap, RefusesGridsThatCannotBe) {
  const auto build = [](double cell, double range) {
    return [=] {
      LocalMapOptions options;
      options.cell_m = cell;
      LocalMapBuilder(range, options);
    };
  };
  expectBadInput(build(0.0, 40.0), {"cell"});
  expectBadInput(build(0.1, -1.0), {"range"});
  expectBadInput(build(0.1, std::nan("")), {"range"});
  expectBadInput(build(0.1, 1e6), {"8192"});
}

TEST(LocalMap, IsRenderedOnceWhenItIsRead) {
  int rendered = 0;
  const LazyLocalMap map(kRange_m, [&] {
    ++rendered;
    return LocalMap(0.1, kRange_m);
  });
  const LazyLocalMap copy = map;
  EXPECT_EQ(copy.range(), kRange_m);
  EXPECT_EQ(rendered, 0);
  EXPECT_EQ(&copy.get(), &map.get());
  EXPECT_EQ(rendered, 1);
  EXPECT_FALSE(LazyLocalMap());
}

}  // namespace
}  // namespace handmap
