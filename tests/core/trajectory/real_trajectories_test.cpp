// The way on real scans, guarded: the figures of core/trajectory/README.md and 20 %.
#include <gtest/gtest.h>

#include "core/evaluation/comparison.h"
#include "core/recording/recording.h"
#include "core/trajectory/scan_odometry_source.h"
#include "core/trajectory/scan_trajectory.h"

namespace handmap {
namespace {

struct DrivenTrajectory {
  TrajectoryError odometry;
  TrajectoryError scans;
  bool usable;
};

/// Odometry whose every motion is `factor` times as wrong.
std::vector<Pose2> worse(const std::vector<Pose2>& odometry, const std::vector<Pose2>& truth,
                         double factor) {
  std::vector<Pose2> result{odometry.front()};
  for (std::size_t i = 1; i < odometry.size(); ++i) {
    const Pose2 measured = between(odometry[i - 1], odometry[i]);
    const Pose2 moved = between(truth[i - 1], truth[i]);
    const double turn = normalizedAngle(measured.heading - moved.heading);
    result.push_back(result.back() * Pose2{moved.x + factor * (measured.x - moved.x),
                                           moved.y + factor * (measured.y - moved.y),
                                           moved.heading + factor * turn});
  }
  return result;
}

/// Both ways start where the truth does.
TrajectoryError errorOf(const std::vector<Pose2>& trajectory, const std::vector<double>& times_s,
                        const Trajectory& truth) {
  const Pose2 start = truth.at(times_s.front()).value() * inverse(trajectory.front());
  std::vector<StampedPose> stamped;
  for (std::size_t i = 0; i < trajectory.size(); ++i)
    stamped.push_back({times_s[i], start * trajectory[i]});
  return compareTrajectories(stamped, truth).value();
}

DrivenTrajectory trajectoryOf(const std::string& name, double factor, ReplayOptions options = {}) {
  const Recording recording = openRecording(std::filesystem::path(HANDMAP_SHARED_DATA) / name);
  const Trajectory truth = recording.truth;
  options.kind = SourceKind::Points;
  const auto source = replay(recording, options);
  std::vector<double> times_s;
  std::vector<Pose2> recorded;
  std::vector<Pose2> true_poses;
  std::vector<std::vector<RangePoint>> scans;
  while (const auto observation = source->next()) {
    times_s.push_back(observation->time_s);
    recorded.push_back(observation->odometry);
    true_poses.push_back(truth.at(observation->time_s).value());
    scans.push_back(allPoints(*observation).points);
  }
  const std::vector<Pose2> odometry = worse(recorded, true_poses, factor);
  ScanTrajectory trajectory({recording.range_limit_m});
  for (std::size_t i = 0; i < scans.size(); ++i) {
    trajectory.add(times_s[i], odometry[i], scans[i]);
  }
  return {errorOf(odometry, times_s, truth), errorOf(trajectory.poses(), times_s, truth),
          trajectory.usable()};
}

class RealTrajectories : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(std::filesystem::path(HANDMAP_SHARED_DATA) / "campus")) {
      GTEST_SKIP() << "no real recordings beside the project";
    }
  }
};

TEST_F(RealTrajectories, Campus) {
  const DrivenTrajectory trajectory = trajectoryOf("campus", 1.0);
  EXPECT_TRUE(trajectory.usable);
  EXPECT_LT(trajectory.scans.rms_m, 1.0);  // its start looks half a degree aside
  EXPECT_LT(trajectory.scans.aligned_rms_m, 0.22);
}

/// Without wheels: 24 m off where nothing but the last motion held a scan along a wall.
TEST_F(RealTrajectories, CampusByScansAlone) {
  const auto folder = std::filesystem::path(HANDMAP_SHARED_DATA) / "campus";
  Recording recording = openRecording(folder);
  const Trajectory truth = readTum(folder / "truth.tum");
  ReplayOptions options;
  options.without_odometry = true;
  const auto source = withScansAlone(replay(std::move(recording), options));
  std::vector<StampedPose> poses;
  while (const auto observation = source->next()) {
    poses.push_back({observation->time_s, observation->odometry});
  }
  EXPECT_LT(compareTrajectories(poses, truth).value().aligned_rms_m, 8.0);
}

TEST_F(RealTrajectories, CampusWithDoubledErrors) {
  const DrivenTrajectory trajectory = trajectoryOf("campus", 2.0);
  EXPECT_TRUE(trajectory.usable);
  EXPECT_LT(trajectory.scans.rms_m, 1.25);
  EXPECT_LT(trajectory.scans.aligned_rms_m, 0.32);
}

TEST_F(RealTrajectories, StreetByLidar) {
  const DrivenTrajectory trajectory = trajectoryOf("street", 1.0, {.from = 40});
  EXPECT_TRUE(trajectory.usable);
  EXPECT_LT(trajectory.scans.rms_m, 0.97);
  EXPECT_LT(trajectory.scans.aligned_rms_m, 0.2);
}

TEST_F(RealTrajectories, NeverMuchWorseThanTheOdometry) {
  for (const std::string name : {"corner", "far-rows/plain-301", "far-rows/turned-311"}) {
    const DrivenTrajectory trajectory = trajectoryOf(name, 1.0);
    EXPECT_LE(trajectory.scans.rms_m, 1.1 * trajectory.odometry.rms_m) << name;
    EXPECT_LE(trajectory.scans.aligned_rms_m, 1.1 * trajectory.odometry.aligned_rms_m) << name;
  }
}

}  // namespace
}  // namespace handmap
