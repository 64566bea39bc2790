#include "core/odometry/stereo_odometry.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "tests/core/base/expect_error.h"
#include "tests/core/odometry/drive.h"

namespace handmap {
namespace {

using test::viewFrom;
using test::yard;

std::optional<VisualMotion> see(StereoOdometry& odometry, const View& view, double time_s) {
  return odometry(view.left, view.right, time_s, view.pan);
}

void expectNear(const Pose2& found, const Pose2& truth, double metres, double degrees) {
  EXPECT_NEAR(found.x, truth.x, metres);
  EXPECT_NEAR(found.y, truth.y, metres);
  EXPECT_NEAR(normalizedAngle(found.heading - truth.heading), 0.0, toRadians(degrees));
}

TEST(StereoOdometry, TellsTheMotionOfTheRobotNotOfTheCamera) {
  StereoOdometry odometry(test::odometryCamera());
  StereoOdometry again(test::odometryCamera());
  // Forward, a turn on the spot (the camera moves, the robot does not), a bend, rest.
  const std::vector<Pose2> poses{
      {0, 0, 0}, {0.6, 0, 0}, {0.6, 0, 0.06}, {1.2, 0.1, 0.1}, {1.2, 0.1, 0.1}};
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const View view = viewFrom(yard(), poses[i]);
    const auto motion = see(odometry, view, 0.1 * static_cast<double>(i));
    const auto same = see(again, view, 0.1 * static_cast<double>(i));
    ASSERT_EQ(motion.has_value(), i > 0);
    if (!motion) continue;
    EXPECT_FALSE(motion->guessed);
    EXPECT_GT(motion->inliers, 100);
    EXPECT_GE(motion->matches, motion->inliers);
    expectNear(motion->motion, between(poses[i - 1], poses[i]), 0.02, 0.1);
    EXPECT_EQ(same->motion, motion->motion);
  }
}

TEST(StereoOdometry, TakesThePanOfTheCameraOff) {
  StereoOdometry odometry(test::odometryCamera());
  see(odometry, viewFrom(yard(), {0, 0, 0}, toRadians(8.0)), 0.0);
  const auto motion = see(odometry, viewFrom(yard(), {0.3, 0.05, 0.03}, toRadians(4.0)), 0.5);
  ASSERT_TRUE(motion);
  EXPECT_FALSE(motion->guessed);
  expectNear(motion->motion, {0.3, 0.05, 0.03}, 0.03, 0.15);
}

TEST(StereoOdometry, FindsItselfAfterAJump) {
  StereoOdometry odometry(test::odometryCamera());
  see(odometry, viewFrom(yard(), {0, 0, 0}), 0.0);
  const Pose2 jump{4.0, -0.5, -0.15};
  const auto motion = see(odometry, viewFrom(yard(), jump), 5.0);
  ASSERT_TRUE(motion);
  EXPECT_FALSE(motion->guessed);
  expectNear(motion->motion, jump, 0.15, 0.7);
}

TEST(StereoOdometry, GoesOnAtTheSpeedOfBeforeWhereNothingIsSeen) {
  StereoOdometry odometry(test::odometryCamera());
  see(odometry, viewFrom(yard(), {0, 0, 0}), 0.0);
  see(odometry, viewFrom(yard(), {0.5, 0, 0.02}), 0.5);
  const cv::Mat fog(375, 1242, CV_8UC1, cv::Scalar(120));
  const auto motion = odometry(fog, fog, 0.75);
  ASSERT_TRUE(motion);
  EXPECT_TRUE(motion->guessed);
  EXPECT_EQ(motion->inliers, 0);
  expectNear(motion->motion, {0.25, 0, 0.01}, 0.02, 0.1);
  // The pair before the fog still counts.
  const auto out = see(odometry, viewFrom(yard(), {1.1, 0, 0.04}), 1.0);
  ASSERT_TRUE(out);
  EXPECT_FALSE(out->guessed);
  expectNear(between({0.5, 0, 0.02}, {1.1, 0, 0.04}), motion->motion * out->motion, 0.05, 0.2);
}

TEST(StereoOdometry, StartsAnewAtAnotherPlace) {
  const test::Scene other{{{{{508, -320}, {508, 30}}, 9.0}}, 0.0};
  StereoOdometry odometry(test::odometryCamera());
  see(odometry, viewFrom(yard(), {0, 0, 0}), 0.0);
  const auto strange = see(odometry, viewFrom(other, {500, 0, 0}), 1.0);
  ASSERT_TRUE(strange);
  EXPECT_TRUE(strange->guessed);
  const auto next = see(odometry, viewFrom(other, {500.2, 0, 0.02}), 1.1);
  ASSERT_TRUE(next);
  EXPECT_FALSE(next->guessed);
  expectNear(next->motion, {0.2, 0, 0.02}, 0.03, 0.2);
}

TEST(StereoOdometry, TakesColourAndRefusesWhatCannotBe) {
  const View view = viewFrom(yard(), {});
  cv::Mat left;
  cv::Mat right;
  cv::cvtColor(view.left, left, cv::COLOR_GRAY2BGR);
  cv::cvtColor(view.right, right, cv::COLOR_GRAY2BGR);
  StereoOdometry odometry(test::odometryCamera());
  odometry(left, right, 0.0);
  const auto rest = odometry(left, right, 0.1);
  ASSERT_TRUE(rest);
  expectNear(rest->motion, {}, 1e-3, 0.01);
  const cv::Mat small = left.colRange(0, 600).clone();
  test::expectBadInput([&] { odometry(small, small, 0.2); }, {"left image", "600 × 375", "same"});
  test::expectBadInput([&] { odometry(left, small, 0.2); }, {"right image"});
  test::expectBadInput([&] { odometry({}, {}, 0.2); }, {"left image"});
  left.convertTo(left, CV_16UC3);
  test::expectBadInput([&] { odometry(left, right, 0.2); }, {"16 bits"});
}

}  // namespace
}  // namespace handmap
