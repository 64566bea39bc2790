#include "core/fastslam/motion_model.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

TEST(MotionModel, WithoutNoiseFollowsTheOdometry) {
  RandomStream random(1);
  const Pose2 motion{2.0, 0.5, 0.3};
  const Pose2 from{10.0, -4.0, 1.2};
  const Pose2 to = samplePose(from, motion, {0, 0, 0, 0, 0}, random);
  const Pose2 expected = from * motion;
  EXPECT_NEAR(to.x, expected.x, 1e-12);
  EXPECT_NEAR(to.y, expected.y, 1e-12);
  EXPECT_NEAR(to.heading, expected.heading, 1e-12);
}

TEST(MotionModel, SpreadIsThatOfTheNoise) {
  MotionNoise noise{0.03, 0.002, 0.0, 0.0, 0.0};
  double length_squares = 0.0;
  double heading_squares = 0.0;
  constexpr int kDraws = 20000;
  for (int i = 0; i < kDraws; ++i) {
    RandomStream random(3, 1, static_cast<std::uint32_t>(i));
    const Pose2 to = samplePose({}, {5.0, 0.0, 0.0}, noise, random);
    length_squares += std::pow(to.position().norm() - 5.0, 2);
    heading_squares += to.heading * to.heading;
  }
  EXPECT_NEAR(std::sqrt(length_squares / kDraws), 0.15, 0.005);
  EXPECT_NEAR(std::sqrt(heading_squares / kDraws), 0.01, 0.0005);
}

TEST(MotionModel, AGuessSpreadsAlongWhatNothingHeld) {
  const Vec2 along = Vec2(1.0, 1.0).normalized();
  Eigen::Matrix3d variance = Eigen::Matrix3d::Zero();
  variance.topLeftCorner<2, 2>() = 9.0 * along * along.transpose();
  Vec2 squares = Vec2::Zero();
  constexpr int kDraws = 20000;
  for (int i = 0; i < kDraws; ++i) {
    RandomStream random(3, 1, static_cast<std::uint32_t>(i));
    const Vec2 off = sampleGuess({5.0, 0.0, 0.1}, variance, random).position() - Vec2(5.0, 0.0);
    squares += Vec2(off.dot(along), cross(along, off)).cwiseAbs2();
  }
  EXPECT_NEAR(std::sqrt(squares.x() / kDraws), 3.0, 0.1);
  EXPECT_NEAR(squares.y(), 0.0, 1e-9);
}

TEST(MotionModel, ParticlesOfAStandingRobotStayApart) {
  RandomStream random(5);
  const Pose2 to = samplePose({}, {}, MotionNoise{}, random);
  EXPECT_NE(to.heading, 0.0);
  EXPECT_LT(std::abs(to.heading), 0.01);
}

}  // namespace
}  // namespace handmap
