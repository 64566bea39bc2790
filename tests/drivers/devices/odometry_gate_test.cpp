#include "drivers/device/odometry_gate.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

TEST(OdometryGate, ASingleLeapIsHeldBack) {
  OdometryGate gate;
  for (int i = 0; i < 20; ++i) {
    const Pose2 true_pose{0.1 * i, 0.0, 0.01 * i};
    if (i == 10) {
      EXPECT_FALSE(gate.pass(0.1 * i, {1000.0, 0.0, 0.0}));
    } else {
      EXPECT_EQ(gate.pass(0.1 * i, true_pose), true_pose);
    }
  }
  EXPECT_EQ(gate.heldBack(), 1);
  EXPECT_EQ(gate.restarts(), 0);
}

TEST(OdometryGate, ABaseThatBeginsAnewGoesOnWhereItWas) {
  OdometryGate gate;
  const Pose2 before{40.0, 5.0, kPi / 2.0};
  EXPECT_TRUE(gate.pass(0.0, before));
  EXPECT_FALSE(gate.pass(0.1, {0.0, 0.0, 0.0}));
  const auto again = gate.pass(0.2, {0.0, 0.0, 0.0});
  ASSERT_TRUE(again);
  EXPECT_NEAR(again->x, 40.0, 1e-9);
  EXPECT_NEAR(again->heading, kPi / 2.0, 1e-9);
  const auto on = gate.pass(0.3, {1.0, 0.0, 0.0});
  EXPECT_NEAR(on->x, 40.0, 1e-9);
  EXPECT_NEAR(on->y, 6.0, 1e-9);
  EXPECT_EQ(gate.restarts(), 1);
  EXPECT_EQ(gate.heldBack(), 0);
}

TEST(OdometryGate, AfterALongGapAFarPoseIsBelieved) {
  OdometryGate gate;
  gate.pass(0.0, {0.0, 0.0, 0.0});
  EXPECT_TRUE(gate.pass(10.0, {50.0, 0.0, 3.0}));
}

}  // namespace
}  // namespace handmap
