#include "core/method/given_start.h"

#include <gtest/gtest.h>

#include "core/odometry/given_poses.h"

namespace handmap {
namespace {

constexpr Pose2 kStart{10.0, -5.0, 0.3};
constexpr double kSpeed_m_s = 1.0;

/// Straight on, at t seconds.
Pose2 trueAt(double time_s) { return kStart * Pose2{kSpeed_m_s * time_s, 0.0, 0.0}; }

/// Wheels on their own: nothing is seen.
Map told(const Pose2& drawn, const std::vector<StampedPose>& given, double scale = 1.0) {
  Map drawing;
  drawing.start = drawn;
  GivenStart start(drawing, SourceInfo{}, given);
  for (int t = 0; !start.isDone() && t <= 60; ++t) {
    start.add(t, Pose2{scale * kSpeed_m_s * t, 0.0, 0.0}, {}, {});
  }
  EXPECT_FALSE(start.isByScans());
  return start.drawing();
}

double off(const Map& drawing) { return between(kStart, *drawing.start).position().norm(); }

TEST(GivenStart, OfWheelsStaysWhereTheyMayHaveDrifted) {
  const Map drawing = told(kStart, {{40.5, trueAt(40.5) * Pose2{3.0, 2.0, 0.1}}}, 1.04);
  EXPECT_EQ(drawing.start, kStart);
  EXPECT_FALSE(drawing.start_uncertainty);
}

TEST(GivenStart, OfWheelsIsElsewhereWhereTheyCannotBeAsFarOff) {
  const Map drawing = told(kStart * Pose2{-20.0, 12.0, 0.4}, {{40.5, trueAt(40.5)}}, 1.04);
  EXPECT_LT(off(drawing), 6.0);
  ASSERT_TRUE(drawing.start_uncertainty);
  EXPECT_LT(off(drawing), 3.0 * drawing.start_uncertainty->position);
}

TEST(GivenStart, IsToldByTheFirstAlongWheels) {
  const Map drawing =
      told(kStart * Pose2{-20.0, 12.0, 0.4}, {{10.0, trueAt(10.0)}, {50.0, Pose2{}}});
  EXPECT_LT(off(drawing), 2.5);
}

TEST(GivenStart, WithoutAWayToAGivenPoseStays) {
  EXPECT_EQ(told(kStart, {{900.0, Pose2{}}}).start, kStart);
}

}  // namespace
}  // namespace handmap
