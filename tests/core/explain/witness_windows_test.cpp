#include "core/explain/witness_windows.h"

#include <gtest/gtest.h>

#include "core/classification/windows.h"

namespace handmap {
namespace {

const cv::Size kSize(640, 480);

StereoCamera camera() {
  StereoCamera camera;
  camera.fx = camera.fy = 320.0;
  camera.cx = 320.0;
  camera.cy = 240.0;
  camera.baseline = 0.5;
  camera.mount.z = 1.5;
  return camera;
}

/// A robot at (5, 5) that looks up; a return 10 m ahead and `left` metres to the left.
WallWitness witness(double left) {
  WallWitness seen;
  seen.pose = {5.0, 5.0, kPi / 2.0};
  seen.returns = {{5.0 - left, 15.0}};
  return seen;
}

TEST(WitnessWindows, StandOnTheGroundWhereTheReturnIs) {
  const auto windows = windowsOf(witness(0.0), camera(), 0.0, {}, kSize);
  ASSERT_FALSE(windows.empty());
  // The foot lies at row 240 + 320 · 1.5 / 10 = 288; three metres up at 192.
  EXPECT_EQ(windows.front().y, 192);
  EXPECT_EQ(windows.back().y, 288);
  for (const cv::Rect& window : windows) EXPECT_EQ(window.x, 320);
}

TEST(WitnessWindows, MoveWithTheReturnAndThePan) {
  const auto left = windowsOf(witness(5.0), camera(), 0.0, {}, kSize);
  ASSERT_FALSE(left.empty());
  EXPECT_EQ(left.front().x, 160);
  const double there = std::atan2(5.0, 10.0) + 0.01;  // a little to the right of the middle
  const auto panned = windowsOf(witness(5.0), camera(), there, {}, kSize);
  ASSERT_FALSE(panned.empty());
  EXPECT_EQ(panned.front().x, 320);
}

TEST(WitnessWindows, AreThoseJudgedToShowABuildingWhereThatIsKnown) {
  cv::Mat1f judged(kSize.height / kWindow_px, kSize.width / kWindow_px, 0.0F);
  judged(5, 20) = 0.9F;
  judged(14, 20) = 0.8F;
  judged(25, 20) = 0.8F;  // below the ground
  judged(14, 21) = 0.8F;  // beside
  const auto windows = windowsOf(witness(0.0), camera(), 0.0, judged, kSize);
  ASSERT_EQ(windows.size(), 2U);
  EXPECT_EQ(windows[0], cv::Rect(320, 80, kWindow_px, kWindow_px));
  EXPECT_EQ(windows[1], cv::Rect(320, 224, kWindow_px, kWindow_px));
}

TEST(WitnessWindows, AreNoneWhereTheCameraLookedElsewhere) {
  EXPECT_TRUE(windowsOf(witness(0.0), camera(), kPi, {}, kSize).empty());
  EXPECT_TRUE(windowsOf(witness(0.0), camera(), kPi / 2.0, {}, kSize).empty());
}

}  // namespace
}  // namespace handmap
