#include "core/estimation/drawing/predicted_motion.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace handmap {
namespace {

DrawingMotion expectedMotion() {
  DrawingMotion motion;
  motion.covariance = Eigen::Vector4d(0.05, 0.02, 1.5, 1.5).cwiseAbs2().asDiagonal();
  return motion;
}

/// Buildings along a street, each drawn off by itself, and all together as `whole` says.
std::vector<Displaced> street(const DrawingMotion& whole, double sigma_m, std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<Displaced> buildings;
  for (int i = 0; i < 12; ++i) {
    const Vec2 drawn(15.0 * i, i % 2 == 0 ? 12.0 : -12.0);
    const Vec2 own(sigma_m * random.normal(), sigma_m * random.normal());
    buildings.push_back({drawn, whole(drawn) + own, 5.0});
  }
  return buildings;
}

TEST(PredictedMotion, WhatAllBuildingsHaveInCommonIsSaidOfTheOthers) {
  DrawingMotion whole;
  whole.mean = {1.1 * std::cos(0.1), 1.1 * std::sin(0.1), 6.0, -4.0};
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    EXPECT_GT(predictiveShare(expectedMotion(), street(whole, 1.0, seed)), 0.7) << seed;
  }
}

TEST(PredictedMotion, ErrorsOfSingleBuildingsAreNot) {
  double sum = 0.0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    sum += predictiveShare(expectedMotion(), street({}, 5.0, seed));
  }
  EXPECT_LT(sum / 50.0, 0.2);
}

TEST(PredictedMotion, OneBuildingSaysNothingOfOthers) {
  const std::vector<Displaced> one = {{{10.0, 5.0}, {18.0, 9.0}, 5.0}};
  EXPECT_EQ(predictiveShare(expectedMotion(), one), 0.0);
  EXPECT_EQ(predictiveShare(expectedMotion(), {}), 0.0);
}

TEST(PredictedMotion, ADrawingMayBeSureOfItsScaleTurnAndPlace) {
  DrawingMotion whole;
  whole.mean = {1.0, 0.0, 6.0, -4.0};
  const double share = predictiveShare(DrawingMotion{}, street(whole, 1.0, 1));
  EXPECT_GE(share, 0.0);
  EXPECT_LT(share, 0.1);
}

TEST(PredictedMotion, IsSaidOfWhatStandsBesideWhatWasFound) {
  EXPECT_EQ(shareAt(0.0, 0.6), 0.6);
  EXPECT_GT(shareAt(30.0, 0.6), 0.45);
  EXPECT_LT(shareAt(200.0, 0.6), 0.001);
  EXPECT_EQ(shareAt(std::numeric_limits<double>::infinity(), 0.6), 0.0);
}

TEST(PredictedMotion, GoesAShareOfTheWay) {
  DrawingMotion found = expectedMotion();
  found.mean = {1.2, 0.2, 8.0, 0.0};
  found.covariance.setZero();
  const DrawingMotion half = predictedMotion(expectedMotion(), found, 0.5);
  EXPECT_TRUE(half.mean.isApprox(Eigen::Vector4d(1.1, 0.1, 4.0, 0.0)));
  EXPECT_TRUE(half.covariance.isApprox(0.5 * expectedMotion().covariance));
}

}  // namespace
}  // namespace handmap
