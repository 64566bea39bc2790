#include "core/estimation/smoothing/odometry_estimate.h"

#include <gtest/gtest.h>

#include "core/odometry/constants.h"

namespace handmap {
namespace {

constexpr double kAssumedVariance = kWheels.heading_variance_per_m;
constexpr double kStep_m = 2.0;

/// After a straight way of 400 m along which the smoothed poses turn by so much a key frame, to the
/// left and to the right, and the odometry does not.
double varianceWhereItTurns(double by) {
  OdometryEstimate estimate(kAssumedVariance);
  std::deque<Frame> frames;
  for (int i = 0; i < 200; ++i) {
    Frame frame;
    frame.driven_m = kStep_m * i;
    frame.odometry = {frame.driven_m, 0.0, 0.0};
    frame.pose = {frame.driven_m, 0.0, by * ((i / 10) % 2 == 0 ? i % 10 : 10 - i % 10)};
    frames.push_back(frame);
    estimate.add(frames);
  }
  return estimate.headingVariance();
}

TEST(OdometryEstimateTest, WhatTurnsAsTheSmoothedPosesDoIsSurerThanAssumed) {
  EXPECT_LT(varianceWhereItTurns(0.0), 0.5 * kAssumedVariance);
  EXPECT_GT(varianceWhereItTurns(0.0), 0.0);
}

TEST(OdometryEstimateTest, TurnsOfTheSmoothedPosesAreTheirOwnBeyondWhatIsAssumed) {
  EXPECT_DOUBLE_EQ(varianceWhereItTurns(0.05), kAssumedVariance);
}

}  // namespace
}  // namespace handmap
