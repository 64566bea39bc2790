#include "core/trajectory/local_map_odometry.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/trajectory/returns.h"
#include "tests/core/trajectory/walled_world.h"

namespace handmap {
namespace {

/// How many of the motions along a street it says that scans alone told.
int told(const std::vector<Segment>& walls, double sigma_m) {
  RandomStream random(5);
  LocalMapOdometry odometry = LocalMapOdometry::ofGuesses();
  int count = 0;
  for (int i = 0; i < 20; ++i) {
    const Pose2 pose{0.15 * i, 0.0, 0.0};
    const auto points = test::scanFrom(walls, pose, sigma_m, random);
    const bool matched = odometry.add(pose, features(usableReturns(points, 40.0)));
    count += matched && !odometry.unheld() ? 1 : 0;
    const Vec2 along = odometry.unheld().value_or(Vec2::UnitX());
    EXPECT_GT(std::abs(along.x()), 0.95);
  }
  return count;
}

TEST(LocalMapOdometry, TwoLongWallsDoNotTellHowFarItWent) {
  std::vector<Segment> walls{{{-200.0, 6.0}, {200.0, 6.0}}, {{-200.0, -6.0}, {200.0, -6.0}}};
  for (const double sigma_m : {0.005, 0.02, 0.05}) EXPECT_LT(told(walls, sigma_m), 3) << sigma_m;
  walls.push_back({{15.0, -6.0}, {15.0, 6.0}});
  for (const double sigma_m : {0.005, 0.02, 0.05}) EXPECT_GT(told(walls, sigma_m), 16) << sigma_m;
}

TEST(LocalMapOdometry, BetweenTwoLongWallsTheGuessGoesOn) {
  const std::vector<Segment> walls{{{-200.0, 6.0}, {200.0, 6.0}}, {{-200.0, -6.0}, {200.0, -6.0}}};
  RandomStream random(6);
  LocalMapOdometry odometry = LocalMapOdometry::ofGuesses();
  for (int i = 0; i < 40; ++i) {
    const Pose2 pose{0.15 * i, 0.0, 0.0};
    const Pose2 guess{0.15 * i, 0.01 * i, 0.0};  // aside the walls hold it
    odometry.add(guess, features(usableReturns(test::scanFrom(walls, pose, 0.02, random), 40.0)));
  }
  EXPECT_NEAR(odometry.pose().x, 0.15 * 39, 0.1);
  EXPECT_NEAR(odometry.pose().y, 0.0, 0.1);
}

/// What a drive of 6 m through a hall says of its heading, one σ, radians.
double headingSigma(double sigma_m, double view_rad) {
  const std::vector<Segment> walls{{{-10.0, 8.0}, {30.0, 8.0}},
                                   {{-10.0, -8.0}, {30.0, -8.0}},
                                   {{30.0, -8.0}, {30.0, 8.0}},
                                   {{-10.0, -8.0}, {-10.0, 8.0}}};
  RandomStream random(7);
  LocalMapOdometry odometry;
  double variance = 0.0;
  for (int i = 0; i < 20; ++i) {
    const Pose2 pose{0.3 * i, 0.0, 0.0};
    auto points = test::scanFrom(walls, pose, sigma_m, random);
    std::erase_if(points,
                  [&](const RangePoint& p) { return std::abs(std::atan2(p.y, p.x)) > view_rad; });
    odometry.add(pose, features(usableReturns(points, 40.0)));
    variance += odometry.variance()(2, 2);
  }
  return std::sqrt(variance);
}

TEST(LocalMapOdometry, StraysByWhatTheMatchesTell) {
  const double good = headingSigma(0.02, kPi);
  EXPECT_LT(good, toRadians(0.3));
  EXPECT_GT(headingSigma(0.2, kPi), 2.0 * good);
  EXPECT_GT(headingSigma(0.02, kPi / 4.0), 1.5 * good);
}

TEST(LocalMapOdometry, StraysAsTheWheelsWhereNothingIsSeen) {
  LocalMapOdometry odometry;
  odometry.add({}, {});
  EXPECT_TRUE(odometry.variance().isZero());
  odometry.add({1.0, 0.0, 0.0}, {});
  const Eigen::Vector3d wheels = odometry.noise().sigma({1.0, 0.0, 0.0});
  EXPECT_TRUE(odometry.variance().isApprox(wheels.cwiseAbs2().asDiagonal().toDenseMatrix()));
}

}  // namespace
}  // namespace handmap
