#include "core/simulation/drive.h"

#include <gtest/gtest.h>

#include "core/simulation/route.h"
#include "core/simulation/world.h"

namespace handmap {
namespace {

SimulationOptions steady(int rounds) {
  SimulationOptions options;
  options.step_m = 1.0;
  options.odometry_length = options.odometry_heading = 0.0;
  options.rounds = rounds;
  return options;
}

TEST(Drive, GoesForwardAndBackInReverseGear) {
  const Map map = twoRowWorld(1).map;
  const Drive once = driveThrough(map, steady(1), 1);
  const Drive often = driveThrough(map, steady(4), 1);
  const double length = routeOf(map)->length();
  ASSERT_EQ(often.truth.size(), static_cast<std::size_t>(4.0 * length) + 1);
  for (std::size_t i = 0; i < once.truth.size(); ++i) {
    EXPECT_EQ(often.truth[i].pose, once.truth[i].pose);
  }
  EXPECT_LT((often.truth.back().pose.position() - once.truth.front().pose.position()).norm(), 1.0);
  for (const StampedPose& stamped : often.truth) EXPECT_NEAR(stamped.pose.heading, 0.0, 1e-9);
  for (std::size_t i = 1; i < often.truth.size(); ++i) {
    const Pose2 step = between(often.truth[i - 1].pose, often.truth[i].pose);
    EXPECT_LT(step.position().norm(), 1.001);
  }
}

TEST(Drive, GoesRoundAgainWhereItComesBack) {
  for (const Map& map : {loopWorld(1).map, terraceWorld(1).map}) {
    const Drive once = driveThrough(map, steady(1), 1);
    const Drive twice = driveThrough(map, steady(2), 1);
    const double loop = routeOf(map)->length() - (map.route.back() - map.route.front()).norm();
    ASSERT_NEAR(static_cast<double>(twice.truth.size() - once.truth.size()), loop, 1.5);
    const auto round = static_cast<std::size_t>(loop);
    for (std::size_t i = 20; i + 20 < round; i += 10) {
      EXPECT_LT((twice.truth[i].pose.position() - twice.truth[i + round].pose.position()).norm(),
                1.1);
      EXPECT_NEAR(
          normalizedAngle(twice.truth[i].pose.heading - twice.truth[i + round].pose.heading), 0.0,
          0.4);
    }
    for (std::size_t i = 1; i < twice.truth.size(); ++i) {
      const Pose2 step = between(twice.truth[i - 1].pose, twice.truth[i].pose);
      EXPECT_LT(step.position().norm(), 1.001);
    }
  }
}

TEST(Drive, AWheelBaseIsOffByItsScaleAndItsBias) {
  SimulationOptions options = steady(1);
  options.odometry_scale = 1.05;
  options.odometry_turn_rad_m = toRadians(0.03);
  const Drive drive = driveThrough(twoRowWorld(1).map, options, 1);
  const double driven = static_cast<double>(drive.truth.size() - 1);
  EXPECT_NEAR(toDegrees(drive.odometry.back().pose.heading), 0.03 * driven, 1e-6);
  double length = 0.0;
  for (std::size_t i = 1; i < drive.odometry.size(); ++i) {
    length += between(drive.odometry[i - 1].pose, drive.odometry[i].pose).position().norm();
  }
  EXPECT_NEAR(length, 1.05 * driven, 1e-6);
}

}  // namespace
}  // namespace handmap
