#include "core/odometry/given_poses.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace handmap {
namespace {

constexpr Pose2 kStart{10.0, -5.0, 0.3};
constexpr Pose2 kStartOdometry{2.0, 1.0, -0.2};

/// The true way, map frame, at 0 … 20 s: a slow bend.
Pose2 trueAt(double time_s) {
  Pose2 pose = kStart;
  for (double t = 0.0; t < time_s; t += 0.5) pose = pose * Pose2{0.5, 0.0, 0.02};
  return pose;
}

/// What wheels say of it that turn too far to the left.
std::vector<StampedPose> drifting() {
  std::vector<StampedPose> poses{{0.0, kStartOdometry}};
  for (double t = 0.5; t <= 20.0; t += 0.5) {
    poses.push_back({t, poses.back().pose * Pose2{0.51, 0.0, 0.025}});
  }
  return poses;
}

Pose2 onMap(const Pose2& odometry) { return kStart * between(kStartOdometry, odometry); }

double apart(const Pose2& a, const Pose2& b) { return (a.position() - b.position()).norm(); }

TEST(GivenPoses, NoneLeaveTheOdometryAsItIs) {
  const Pose2 somewhere{3.0, 4.0, 1.0};
  EXPECT_EQ(GivenPoses()(7.0, somewhere), somewhere);
  EXPECT_EQ(GivenPoses(kStart, kStartOdometry, drifting(), {})(7.0, somewhere), somewhere);
}

TEST(GivenPoses, LeadThroughEveryGivenPose) {
  const auto odometry = drifting();
  const std::vector<StampedPose> given{{6.0, trueAt(6.0)}, {14.25, trueAt(14.0)}};
  const GivenPoses bent(kStart, kStartOdometry, odometry, given);
  EXPECT_LT(apart(onMap(bent(0.0, kStartOdometry)), kStart), 1e-9);
  for (const StampedPose& pose : given) {
    const Pose2 there = onMap(bent(pose.time_s, *Trajectory(odometry, "").at(pose.time_s)));
    EXPECT_LT(apart(there, pose.pose), 1e-9);
    EXPECT_NEAR(normalizedAngle(there.heading - pose.pose.heading), 0.0, 1e-9);
  }
}

TEST(GivenPoses, SpreadTheDriftOverTheWay) {
  const auto odometry = drifting();
  const GivenPoses bent(kStart, kStartOdometry, odometry, {{20.0, trueAt(20.0)}});
  for (const StampedPose& pose : odometry) {
    const double before = apart(onMap(pose.pose), trueAt(pose.time_s));
    const double after = apart(onMap(bent(pose.time_s, pose.pose)), trueAt(pose.time_s));
    EXPECT_LE(after, 0.25 + 0.1 * before) << pose.time_s;
  }
  // Neighbours stay neighbours: no step is another one by more than the drift.
  for (std::size_t i = 1; i < odometry.size(); ++i) {
    const Pose2 step = between(bent(odometry[i - 1].time_s, odometry[i - 1].pose),
                               bent(odometry[i].time_s, odometry[i].pose));
    EXPECT_NEAR(step.x, 0.5, 0.05);
    EXPECT_NEAR(step.y, 0.0, 0.05);
    EXPECT_NEAR(step.heading, 0.02, 0.005);
  }
}

TEST(GivenPoses, GoOnByOdometryAfterTheLast) {
  const auto odometry = drifting();
  const GivenPoses bent(kStart, kStartOdometry, odometry, {{10.0, Pose2{50.0, 50.0, 1.0}}});
  const Pose2 step = between(bent(15.0, odometry[30].pose), bent(15.5, odometry[31].pose));
  const Pose2 recorded = between(odometry[30].pose, odometry[31].pose);
  EXPECT_NEAR(step.x, recorded.x, 1e-9);
  EXPECT_NEAR(step.heading, recorded.heading, 1e-9);
}

TEST(GivenPoses, OfARobotThatStandsTakeIt) {
  const std::vector<StampedPose> standing{{0.0, kStartOdometry}, {1.0, kStartOdometry}};
  const GivenPoses bent(kStart, kStartOdometry, standing, {{1.0, Pose2{20.0, 5.0, -1.0}}});
  EXPECT_LT(apart(onMap(bent(1.0, kStartOdometry)), {20.0, 5.0, -1.0}), 1e-9);
}

TEST(GivenPoses, OutsideTheOdometryAreRefused) {
  EXPECT_THROW(GivenPoses(kStart, kStartOdometry, drifting(), {{30.0, kStart}}), Error);
  EXPECT_THROW(GivenPoses(kStart, kStartOdometry, {}, {{3.0, kStart}}), Error);
}

}  // namespace
}  // namespace handmap
