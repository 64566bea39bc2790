// Visual odometry on real drives, beside the odometry that came with them.
#include <filesystem>
#include <iostream>

#include <gtest/gtest.h>

#include "core/odometry/stereo_odometry.h"
#include "core/recording/recording.h"

namespace handmap {
namespace {

struct Drive {
  int steps = 0;
  int guessed = 0;
  double length_m = 0.0;
  double end_m = 0.0;  ///< error of the end, seen from the first pose
  double heading = 0.0;
  double given_end_m = 0.0;   ///< the same of the recording's own odometry
  double from_given_m = 0.0;  ///< between the two
};

Drive drive(const char* name, const ReplayOptions& options) {
  const Recording recording = openRecording(std::filesystem::path(HANDMAP_SHARED_DATA) / name);
  const auto source = replay(recording, options);
  StereoOdometry odometry(source->info().camera.value());
  Drive result;
  Pose2 pose;
  Pose2 truth_before;
  std::optional<Pose2> start;
  Pose2 given_start;
  Pose2 end;
  Pose2 given_end;
  while (const auto observation = source->next()) {
    const View& view = observation->views.front();
    const auto motion = odometry(view.left, view.right, observation->time_s, view.pan);
    const Pose2 truth = recording.truth.at(observation->time_s).value();
    if (!start) {
      start = truth;
      given_start = observation->odometry;
    } else {
      result.length_m += (truth.position() - truth_before.position()).norm();
    }
    if (motion) {
      pose = pose * motion->motion;
      ++result.steps;
      result.guessed += motion->guessed;
    }
    truth_before = truth;
    end = between(*start, truth);
    given_end = between(given_start, observation->odometry);
  }
  result.end_m = (pose.position() - end.position()).norm();
  result.heading = normalizedAngle(pose.heading - end.heading);
  result.given_end_m = (given_end.position() - end.position()).norm();
  result.from_given_m = (pose.position() - given_end.position()).norm();
  std::cout << name << ": " << result.steps << " steps, " << result.guessed << " guessed, "
            << result.length_m << " m; end off by " << result.end_m << " m ("
            << 100.0 * result.end_m / result.length_m << " %), " << pose.x << ',' << pose.y
            << " vs " << end.x << ',' << end.y << ' ' << toDegrees(result.heading)
            << " deg; the recording's own odometry by " << result.given_end_m << " m\n";
  return result;
}

TEST(StereoOdometry, FollowsTheRealStreet) {
  if (!std::filesystem::exists(std::filesystem::path(HANDMAP_SHARED_DATA) / "street")) {
    GTEST_SKIP() << "no street recording";
  }
  for (const int every : {4, 10}) {  // 3 m and 8 m from pair to pair
    const Drive street = drive("street", {.from = 40, .every = every, .kind = SourceKind::Images});
    EXPECT_EQ(street.guessed, 0);
    EXPECT_LT(street.end_m, 0.006 * street.length_m);
    EXPECT_LT(std::abs(street.heading), toRadians(1.0));
  }
}

TEST(StereoOdometry, FollowsTheRealKittiFolder) {
  if (!std::filesystem::exists(std::filesystem::path(HANDMAP_SHARED_DATA) / "kitti-odometry-06")) {
    GTEST_SKIP() << "no KITTI folder";
  }
  const Drive kitti = drive("kitti-odometry-06", {});
  EXPECT_EQ(kitti.guessed, 0);
  // GPS, smoothed, is 1 % shorter than either odometry over these 24 m.
  EXPECT_LT(kitti.end_m, 0.015 * kitti.length_m);
  EXPECT_LT(kitti.from_given_m, 0.005 * kitti.length_m);
}

}  // namespace
}  // namespace handmap
