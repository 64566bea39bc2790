#include "drivers/device/clock_offset.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace handmap {
namespace {

TEST(ClockOffset, DelaysAreTakenOut) {
  ClockOffset offset;
  RandomStream random(3);
  double worst = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const double measured = 0.05 * i;
    const double arrival = measured + 0.002 + 0.1 * random.uniform() * random.uniform();
    const auto time = offset.rigTime(measured + 1.7e9, arrival);
    if (time && i > 100) worst = std::max(worst, std::abs(*time - measured));
  }
  EXPECT_LT(worst, 0.01);
  EXPECT_EQ(offset.jumps(), 0);
}

TEST(ClockOffset, AClockThatRunsAtAnotherSpeedIsFollowed) {
  ClockOffset offset;
  RandomStream random(4);
  for (int i = 0; i < 72'000; ++i) {  // two hours, 100 ppm slow
    const double measured = 0.1 * i;
    const double stamp = measured * (1.0 - 1e-4);
    const auto time = offset.rigTime(stamp, measured + 0.001 + 0.02 * random.uniform());
    if (time) {
      ASSERT_NEAR(*time, measured, 0.03) << i;
    }
  }
  EXPECT_EQ(offset.jumps(), 0);
}

TEST(ClockOffset, JumpsBothWaysAreFoundAtOnce) {
  for (const double jump : {-3600.0, -1.0, 1.0, 3600.0}) {
    ClockOffset offset;
    double last = 0.0;
    for (int i = 1; i < 100; ++i) {
      const double measured = 0.1 * i;
      const double stamp = measured + (i >= 50 ? jump : 0.0);
      const auto time = offset.rigTime(stamp, measured + 0.01);
      ASSERT_TRUE(time) << jump << " " << i;
      EXPECT_NEAR(*time, measured, 0.02);
      EXPECT_GT(*time, last);
      last = *time;
    }
    EXPECT_EQ(offset.jumps(), 1) << jump;
  }
}

TEST(ClockOffset, AClockSetBackByLessThanTheTimeBetweenMessagesIsFoundInTime) {
  ClockOffset offset;
  for (int i = 0; i < 40; ++i) {
    const double measured = i;
    const auto time = offset.rigTime(measured - (i >= 20 ? 0.5 : 0.0), measured + 0.01);
    if (i >= 30) {
      EXPECT_NEAR(time.value(), measured, 0.02);
    }
  }
  EXPECT_EQ(offset.jumps(), 1);
}

TEST(ClockOffset, RepeatedAndDisorderedOnesAreNotUsed) {
  ClockOffset offset;
  EXPECT_TRUE(offset.rigTime(10.0, 1.0));
  EXPECT_FALSE(offset.rigTime(10.0, 1.01));
  EXPECT_FALSE(offset.rigTime(9.98, 1.02));
  EXPECT_TRUE(offset.rigTime(10.1, 1.1));
  EXPECT_EQ(offset.jumps(), 0);
}

TEST(ClockOffset, WhatWaitedBeforeAnybodyListenedIsNoJump) {
  ClockOffset offset;
  for (int i = 0; i < 10; ++i) offset.rigTime(0.1 * i, 3.0 + 1e-3 * i);
  for (int i = 30; i < 100; ++i) {
    EXPECT_NEAR(offset.rigTime(0.1 * i, 0.1 * i + 0.05).value(), 0.1 * i + 0.05, 1e-6);
  }
  EXPECT_EQ(offset.jumps(), 0);
}

// As when a program did not get to run for a while: all comes at once, and nothing is out of place.
TEST(ClockOffset, WhatComesLateIsPlacedWhereItWasMeasured) {
  ClockOffset offset;
  for (int i = 0; i < 100; ++i) offset.rigTime(0.1 * i, 0.1 * i + 0.01);
  for (int i = 100; i < 200; ++i) {
    EXPECT_NEAR(offset.rigTime(0.1 * i, 20.5).value(), 0.1 * i + 0.01, 1e-6);
  }
  EXPECT_EQ(offset.jumps(), 0);
}

}  // namespace
}  // namespace handmap
