#include "core/perception/low_things.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

TEST(LowThings, WhatRaysPassOverIsLow) {
  LowThings things(1.9, 2.9, 40.0);
  const Vec2 fence(3.2, 5.1);
  for (int i = 0; i < 50; ++i) things.addStop(fence, 2.1);
  EXPECT_FALSE(things.isLow(fence));
  for (int i = 0; i < 5; ++i) things.addPass(fence, 2.5);
  EXPECT_TRUE(things.isLow(fence));
  EXPECT_FALSE(things.isLow(fence + Vec2(1.0, 0.0)));
}

TEST(LowThings, AWindowIsNoEnd) {
  LowThings things(1.9, 2.9, 40.0);
  const Vec2 wall(-3.2, 5.1);
  for (int i = 0; i < 12; ++i) things.addPass(wall, 2.2);
  for (int i = 0; i < 6; ++i) things.addStop(wall, 3.5);  // above the window
  EXPECT_FALSE(things.isLow(wall));
}

TEST(LowThings, HeightsThatSayNothingAreLeftOut) {
  LowThings things(1.9, 2.9, 40.0);
  const Vec2 at(0.0, 10.0);
  for (int i = 0; i < 100; ++i) {
    things.addPass(at, 1.0);
    things.addPass(at, 3.0);
  }
  EXPECT_FALSE(things.isLow(at));
}

TEST(LowThings, ForgetsWhatIsFarBehind) {
  LowThings things(1.9, 2.9, 40.0);
  const Vec2 at(0.0, 10.0);
  for (int i = 0; i < 5; ++i) things.addPass(at, 2.5);
  EXPECT_TRUE(things.isLow(at));
  for (double x = 0.0; x < 2000.0; x += 0.5) things.addStop({x, 10.0}, 2.0);
  EXPECT_FALSE(things.isLow(at));
}

}  // namespace
}  // namespace handmap
