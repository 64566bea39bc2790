#include "core/trajectory/scan_trajectory.h"

#include <gtest/gtest.h>

#include "tests/core/trajectory/walled_world.h"

namespace handmap {
namespace {

ScanTrajectory drive(const std::vector<Pose2>& truth, const std::vector<Pose2>& odometry,
                     double sigma_m, bool close_loops = true, double view_rad = kPi) {
  const auto walls = test::ringCorridor();
  RandomStream random(2);
  ScanTrajectory trajectory({40.0, close_loops});
  for (std::size_t i = 0; i < truth.size(); ++i) {
    auto points = test::scanFrom(walls, truth[i], sigma_m, random);
    std::erase_if(points,
                  [&](const RangePoint& p) { return std::abs(std::atan2(p.y, p.x)) > view_rad; });
    trajectory.add(0.1 * static_cast<double>(i), odometry[i], points);
  }
  return trajectory;
}

class AroundTheBlock : public ::testing::Test {
 protected:
  AroundTheBlock() {
    RandomStream random(1);
    odometry_ = test::slipping(truth_, random);
  }
  std::vector<Pose2> truth_ = test::aroundTheBlock(1.2);
  std::vector<Pose2> odometry_;
};

TEST_F(AroundTheBlock, DriftIsCured) {
  const auto trajectory = drive(truth_, odometry_, 0.03, false);
  EXPECT_GT(test::rms(odometry_, truth_), 3.0);
  EXPECT_LT(test::rms(trajectory.poses(), truth_), 1.0);
  EXPECT_TRUE(trajectory.usable());
  EXPECT_EQ(trajectory.loops(), 0);
  EXPECT_NEAR(trajectory.lengthScale(), 1.0 / 1.02, 0.005);
  EXPECT_NEAR(trajectory.rangeNoise(8.0), 0.03, 0.01);
  EXPECT_LT(trajectory.turn(), toRadians(2.0));
  EXPECT_GT(drive(truth_, odometry_, 0.2, false).turn(), 2.0 * trajectory.turn());
}

TEST_F(AroundTheBlock, LoopsAreClosed) {
  const auto trajectory = drive(truth_, odometry_, 0.03);
  EXPECT_GT(trajectory.loops(), 0);
  EXPECT_LT(test::rms(trajectory.poses(), truth_), 0.3);
  EXPECT_EQ(trajectory.poses().size(), truth_.size());
  EXPECT_EQ(trajectory.poses().front(), odometry_.front());
  EXPECT_LT(trajectory.noiseScale(), 0.5);
}

TEST_F(AroundTheBlock, TheSameAgain) {
  EXPECT_TRUE(drive(truth_, odometry_, 0.03).poses() == drive(truth_, odometry_, 0.03).poses());
}

TEST_F(AroundTheBlock, WithNoisyRangesAndANarrowViewToo) {
  EXPECT_LT(test::rms(drive(truth_, odometry_, 0.3).poses(), truth_), 0.3);
  EXPECT_LT(test::rms(drive(truth_, odometry_, 0.03, true, kPi / 4.0).poses(), truth_), 0.3);
  EXPECT_LT(test::rms(drive(truth_, odometry_, 0.3, true, kPi / 4.0).poses(), truth_), 0.5);
}

TEST_F(AroundTheBlock, ANoisySensorIsLeftAlone) {
  const auto trajectory = drive(truth_, odometry_, 0.8);
  EXPECT_FALSE(trajectory.usable());
  EXPECT_TRUE(trajectory.poses() == odometry_);
  EXPECT_EQ(trajectory.noiseScale(), 1.0);
}

TEST_F(AroundTheBlock, WhetherItIsUsableChangesOnlyWhereItIsJudgedAnew) {
  const auto walls = test::ringCorridor();
  RandomStream random(2);
  ScanTrajectory trajectory({40.0});
  for (std::size_t i = 0; i < 72; ++i)  // judged then, and at 90
    trajectory.add(0.0, odometry_[i], test::scanFrom(walls, truth_[i], 0.03, random));
  EXPECT_TRUE(trajectory.usable());
  for (std::size_t i = 72; i < 89; ++i) {
    std::vector<RangePoint> bushes(20000);
    for (RangePoint& p : bushes) {
      p = {static_cast<float>(random.uniform(-20.0, 20.0)),
           static_cast<float>(random.uniform(-20.0, 20.0)), 0.0F, 1.0F};
    }
    trajectory.add(0.0, odometry_[i], bushes);
    EXPECT_TRUE(trajectory.usable()) << i;
  }
  trajectory.add(0.0, odometry_[89], {});
  EXPECT_FALSE(trajectory.usable());
}

TEST_F(AroundTheBlock, WhatTellsTheMotionBetterIsFollowed) {
  const auto walls = test::ringCorridor();
  RandomStream random(2);
  ScanTrajectory trajectory({40.0, false});
  for (std::size_t i = 0; i < truth_.size(); ++i) {
    const auto moved =
        i % 10 != 0 ? std::optional(between(truth_[i - 1], truth_[i])) : std::nullopt;
    trajectory.add(0.1 * static_cast<double>(i), odometry_[i],
                   test::scanFrom(walls, truth_[i], 0.1, random), {}, {}, moved);
  }
  EXPECT_TRUE(trajectory.isFollowed());
  EXPECT_LT(test::rms(trajectory.poses(), truth_), 1.0);
  EXPECT_TRUE(trajectory.recorded() == odometry_);
  EXPECT_FALSE(drive(truth_, odometry_, 0.1, false).isFollowed());
}

TEST_F(AroundTheBlock, WithoutReturnsTheOdometryGoesOn) {
  ScanTrajectory trajectory({40.0});
  for (const Pose2& pose : odometry_) trajectory.add(0.0, pose, {});
  EXPECT_FALSE(trajectory.usable());
  EXPECT_TRUE(trajectory.poses() == odometry_);
  EXPECT_LT(test::rms(trajectory.scanPoses(), odometry_), 1e-6);
}

TEST_F(AroundTheBlock, AStopLeavesOutTheLoops) {
  const auto walls = test::ringCorridor();
  RandomStream random(2);
  std::stop_source stopped;
  stopped.request_stop();
  ScanTrajectory trajectory({40.0});
  for (std::size_t i = 0; i < truth_.size(); ++i) {
    trajectory.add(0.0, odometry_[i], test::scanFrom(walls, truth_[i], 0.03, random),
                   stopped.get_token());
  }
  EXPECT_EQ(trajectory.loops(), 0);
  EXPECT_EQ(trajectory.poses().size(), truth_.size());
}

TEST(ScanTrajectory, BadReturnsDoNoHarm) {
  ScanTrajectory trajectory({40.0});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  for (int i = 0; i < 30; ++i) {
    trajectory.add(0.0, Pose2{0.5 * i, 0, 0},
                   {{nan, 1, 0, 1}, {inf, 1, 0, 1}, {1, 1, nan, 1}, {0, 0, 0, 1}});
  }
  EXPECT_NEAR(trajectory.odometry().x, 14.5, 1e-9);
}

}  // namespace
}  // namespace handmap
