#include "core/trajectory/odometry_choice.h"

#include <gtest/gtest.h>

#include "tests/core/base/expect_error.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/core/trajectory/walled_world.h"

namespace handmap {
namespace {

/// Half way around the block, recorded with a laser of this noise.
class OdometryChoice : public ::testing::Test {
 protected:
  Recording record(double sigma_m) {
    RandomStream random(4);
    const auto odometry = test::slipping(truth_, random);
    SourceInfo info;
    info.name = "Around the block";
    info.range_limit_m = 40.0;
    RecordingWriter writer(folder_.path() / "rec", info);
    for (std::size_t i = 0; i < truth_.size(); ++i) {
      Observation observation;
      observation.frame = static_cast<int>(i);
      observation.time_s = 0.5 * static_cast<double>(i);
      observation.odometry = odometry[i];
      observation.views.emplace_back().points = test::scanFrom(walls_, truth_[i], sigma_m, random);
      writer.add(observation, truth_[i]);
    }
    return openRecording(folder_.path() / "rec");
  }

  std::vector<Pose2> trajectoryOf(ObservationSource& source) {
    std::vector<Pose2> trajectory;
    while (const auto observation = source.next()) trajectory.push_back(observation->odometry);
    return trajectory;
  }

  test::TemporaryFolder folder_;
  std::vector<Segment> walls_ = test::ringCorridor();
  std::vector<Pose2> truth_ = test::aroundTheBlock(0.5);
};

TEST_F(OdometryChoice, ScansCureTheRecordedOne) {
  const Recording recording = record(0.03);
  const auto recorded =
      trajectoryOf(*replayWithOdometry(recording, {}, OdometryKind::Recorded).source);
  const ChosenOdometry scan = replayWithOdometry(recording, {}, OdometryKind::Scan);
  EXPECT_EQ(scan.source->info().start_odometry, recorded.front());
  EXPECT_TRUE(scan.source->info().odometry.empty());
  const auto by_scans = trajectoryOf(*scan.source);
  EXPECT_EQ(by_scans.front(), recorded.front());
  EXPECT_GT(test::rms(recorded, truth_), 1.0);
  EXPECT_LT(test::rms(by_scans, truth_), 0.5);
}

TEST_F(OdometryChoice, AutoTakesTheSharpest) {
  const ChosenOdometry choice = replayWithOdometry(record(0.03), {}, OdometryKind::Auto);
  EXPECT_EQ(choice.kind, OdometryKind::Scan);
  EXPECT_EQ(choice.reason.find("sharpness "), 0U) << choice.reason;
  EXPECT_LT(test::rms(trajectoryOf(*choice.source), truth_), 0.5);
}

TEST_F(OdometryChoice, AutoKeepsTheRecordedOneOfANoisySensor) {
  const ChosenOdometry choice = replayWithOdometry(record(0.8), {}, OdometryKind::Auto);
  EXPECT_EQ(choice.kind, OdometryKind::Recorded);
}

TEST_F(OdometryChoice, WhatCannotBeIsRefused) {
  Recording recording = record(0.03);
  test::expectBadInput(
      [&] { replayWithOdometry(recording, {.kind = SourceKind::Images}, OdometryKind::Scan); },
      {"range points for odometry from scans"});
}

TEST_F(OdometryChoice, WithoutOdometryTheScansTellTheMotion) {
  Recording recording = record(0.03);
  recording.odometry = {};
  for (const OdometryKind kind : {OdometryKind::Recorded, OdometryKind::Auto}) {
    const ChosenOdometry choice = replayWithOdometry(recording, {}, kind);
    EXPECT_EQ(choice.kind, OdometryKind::Scan);
    while (choice.source->next()) continue;
  }
}

TEST(OdometryKind, HasNames) {
  EXPECT_EQ(nameOf(OdometryKind::Recorded), "recorded");
  EXPECT_EQ(nameOf(OdometryKind::Visual), "visual");
  EXPECT_EQ(nameOf(OdometryKind::Scan), "scan");
  EXPECT_EQ(nameOf(OdometryKind::Auto), "auto");
}

}  // namespace
}  // namespace handmap
