#include "core/odometry/odometry_noise.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

TEST(OdometryNoise, AGuessIsOffAlongItsDirectionTheMoreTheLonger) {
  Guess guess;
  guess.hold();
  const Vec2 along = unitVector(0.5);
  for (int i = 0; i < 40; ++i) guess.goOn(0.25, Guess::Of::Along, along);
  const Eigen::Matrix2d ten_s = guess.variance().topLeftCorner<2, 2>();
  EXPECT_NEAR(std::sqrt(along.dot(ten_s * along)), 5.0, 1e-9);  // half of what it may drive
  EXPECT_NEAR(perpendicular(along).dot(ten_s * perpendicular(along)), 0.0, 1e-9);
  EXPECT_EQ(guess.variance()(2, 2), 0.0);
  guess.hold();
  EXPECT_EQ(guess.off_m(), 0.0);
  guess.goOn(0.25, Guess::Of::Along, along);
  EXPECT_LT(std::sqrt(along.dot(guess.variance().topLeftCorner<2, 2>() * along)), 5.01);
}

TEST(OdometryNoise, OfARobotThatNeverWasSeenMovingTheSpeedIsNotKnown) {
  Guess guess;
  for (int i = 0; i < 40; ++i) guess.goOn(0.25, Guess::Of::All);
  EXPECT_NEAR(guess.off_m(), 10.0, 1e-9);
  EXPECT_NEAR(std::sqrt(guess.variance()(2, 2)), 5.0, 1e-9);
}

TEST(OdometryNoise, WhatWasGuessedIsTurnedIntoTheFrameOfTheFirstPose) {
  Odometry from{{1.0, 2.0, kPi / 2.0}};
  Odometry to{{1.0, 5.0, kPi / 2.0}};
  to.guessed(1, 1) = 9.0;  // along y, which is ahead
  const Eigen::Matrix3d guessed = guessedOf(from, to);
  EXPECT_NEAR(guessed(0, 0), 9.0, 1e-9);
  EXPECT_NEAR(guessed(1, 1), 0.0, 1e-9);
}

}  // namespace
}  // namespace handmap
