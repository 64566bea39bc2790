#include <algorithm>

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/recording/as_written.h"
#include "core/recording/validation.h"
#include "tests/core/base/comma_locale.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/base/file_size_limit.h"
#include "tests/core/recording/example_recording.h"

namespace handmap {
namespace {

SourceInfo cameraInfo() {
  SourceInfo info;
  info.name = "Recorded \"live\"";
  info.range_limit_m = 25.0;
  info.camera = StereoCamera{700.5, 701.5, 16.25, 120, 0.4, {0.1, 0.2, 1.5, 0.05, -0.1}};
  return info;
}

Observation movingObservation(int frame) {
  Observation observation;
  observation.frame = frame;
  observation.time_s = 0.1 * frame;
  observation.odometry = {1.0 * frame, 0.5, 0.1};
  View& view = observation.views.emplace_back();
  view.left = test::exampleImage(frame);
  view.right = test::exampleImage(frame + 100);
  view.points = std::vector<RangePoint>{{1.0f * static_cast<float>(frame), 2, 3, 0.5f}};
  return observation;
}

TEST(RecordingWriter, WhatItWritesReplays) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "new";
  {
    const test::CommaLocale comma;
    RecordingWriter writer(path, cameraInfo());
    for (int frame = 3; frame < 6; ++frame) {
      writer.add(movingObservation(frame), Pose2{2.0 * frame, 1, 0.2});
    }
  }
  const Recording recording = openRecording(path);
  EXPECT_TRUE(problemsOf(recording).empty());
  EXPECT_EQ(recording.name, "Recorded \"live\"");
  EXPECT_EQ(recording.range_limit_m, 25.0);
  ASSERT_TRUE(recording.camera);
  EXPECT_EQ(recording.camera->fx, 700.5);
  EXPECT_EQ(recording.camera->cx, 16.25);
  EXPECT_NEAR(recording.camera->baseline, 0.4, 1e-12);
  EXPECT_NEAR(recording.camera->mount.pitch, 0.05, 1e-12);
  EXPECT_NEAR(recording.camera->mount.yaw, -0.1, 1e-12);
  EXPECT_EQ(recording.camera->mount.z, 1.5);
  ASSERT_EQ(recording.truth.poses().size(), 3u);
  EXPECT_EQ(recording.truth.poses()[1].pose.x, 8.0);

  const auto images = replay(recording, {});
  for (int frame = 3; frame < 6; ++frame) {
    const auto observation = images->next();
    ASSERT_TRUE(observation);
    const Observation expected = movingObservation(frame);
    EXPECT_EQ(observation->frame, frame);
    EXPECT_EQ(observation->time_s, expected.time_s);
    EXPECT_FALSE(observation->standing);
    EXPECT_NEAR(observation->odometry.x, expected.odometry.x, 1e-6);
    EXPECT_NEAR(observation->odometry.heading, expected.odometry.heading, 1e-8);
    EXPECT_TRUE(test::sameImage(observation->views[0].left, expected.views[0].left));
    EXPECT_TRUE(test::sameImage(observation->views[0].right, expected.views[0].right));
  }
  const auto points = replay(recording, {.kind = SourceKind::Points});
  EXPECT_EQ(test::pointBytes(*points->next()->views[0].points),
            test::pointBytes(*movingObservation(3).views[0].points));
}

TEST(RecordingWriter, KeepsTheViewsOfAStop) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "new";
  RecordingWriter writer(path, SourceInfo{});
  for (int frame = 0; frame < 2; ++frame) {
    Observation observation;
    observation.frame = frame;
    observation.time_s = 10.0 * frame;
    observation.standing = true;
    for (int i = 0; i < 4; ++i) {
      View& view = observation.views.emplace_back();
      view.pan = toRadians(90.0 * i - 180.0);
      view.points = std::vector<RangePoint>{{static_cast<float>(10 * frame + i), 0, 0, 1}};
    }
    writer.add(observation);
  }
  const Recording recording = openRecording(path);
  EXPECT_FALSE(recording.camera);
  EXPECT_TRUE(recording.truth.empty());
  const auto source = replay(recording, {});
  ASSERT_EQ(source->info().observations, 2);
  source->next();
  const auto observation = source->next();
  EXPECT_TRUE(observation->standing);
  ASSERT_EQ(observation->views.size(), 4u);
  EXPECT_DOUBLE_EQ(observation->views[3].pan, kPi / 2.0);
  EXPECT_EQ(observation->views[3].points->front().x, 13.0f);
}

TEST(RecordingWriter, IsReadableWhileItGrows) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "new";
  RecordingWriter writer(path, cameraInfo());
  for (int frame = 0; frame < 3; ++frame) {
    writer.add(movingObservation(frame));
    const Recording recording = openRecording(path);
    EXPECT_EQ(recording.rows.size(), static_cast<std::size_t>(frame) + 1);
    EXPECT_TRUE(problemsOf(recording).empty());
  }
}

TEST(RecordingWriter, AFullDiskLeavesWholeRows) {
  const test::TemporaryFolder folder;
  RecordingWriter writer(folder.path(), SourceInfo{});
  int written = 0;
  {
    const test::FileSizeLimit limit(500);
    const auto fill = [&] {
      for (;; ++written) {
        Observation observation = movingObservation(written);
        observation.views[0].left.release();
        writer.add(observation);
      }
    };
    test::expectError(ErrorCode::RunFailed, fill,
                      {"odometry.tum: cannot be written: File too large"});
  }
  EXPECT_GT(written, 3);
  const Recording recording = openRecording(folder.path());
  EXPECT_EQ(recording.rows.size(), static_cast<std::size_t>(written));
  EXPECT_EQ(recording.odometry.poses().size(), static_cast<std::size_t>(written));
}

TEST(RecordingWriter, KeepsAScanInWhichNothingCameBack) {
  const test::TemporaryFolder folder;
  RecordingWriter writer(folder.path(), SourceInfo{});
  for (int frame = 0; frame < 3; ++frame) {
    Observation observation = movingObservation(frame);
    observation.views[0].left.release();
    if (frame == 1) observation.views[0].points->clear();
    writer.add(observation);
  }
  const Recording recording = openRecording(folder.path());
  EXPECT_EQ(test::framesOf(*replay(recording, {})), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(recording.odometry.poses().size(), 3u);
}

TEST(RecordingWriter, KeepsWhichFeaturesPointsAre) {
  const test::TemporaryFolder folder;
  RecordingWriter writer(folder.path(), SourceInfo{});
  for (int frame = 0; frame < 4; ++frame) {
    Observation observation = movingObservation(frame);
    observation.views[0].left.release();
    observation.views[0].points = {{1, 0, 0, 1}, {2, 0, 0, 1}};
    if (frame % 2 == 1) observation.views[0].ids = {7, static_cast<std::uint32_t>(frame)};
    writer.add(observation);
  }
  const auto source = replay(openRecording(folder.path()), {});
  const std::vector<std::vector<std::uint32_t>> expected{{0, 0}, {7, 1}, {0, 0}, {7, 3}};
  for (const std::vector<std::uint32_t>& ids : expected) {
    EXPECT_EQ(source->next()->views[0].ids, ids);
  }
}

TEST(RecordingWriter, PutsTheScansOfAMinuteIntoOneFile) {
  const test::TemporaryFolder folder;
  RecordingWriter writer(folder.path(), SourceInfo{});
  for (int frame = 0; frame < 1300; ++frame) {  // ten a second
    Observation observation = movingObservation(frame);
    observation.views[0].left.release();
    writer.add(observation);
  }
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "points")) {
    files.push_back(entry.path().filename().string());
  }
  std::sort(files.begin(), files.end());
  EXPECT_EQ(files,
            (std::vector<std::string>{"minute-0000.bin", "minute-0001.bin", "minute-0002.bin"}));
  const auto source = replay(openRecording(folder.path()), {});
  for (int frame = 0; frame < 1300; ++frame) {
    ASSERT_EQ(source->next()->views[0].points->front().x, static_cast<float>(frame));
  }
}

TEST(RecordingWriter, RefusesAFolderThatIsNotEmpty) {
  const test::TemporaryFolder folder;
  EXPECT_NO_THROW(RecordingWriter(folder.path(), SourceInfo{}));
  test::expectError(ErrorCode::RunFailed, [&] { RecordingWriter(folder.path(), SourceInfo{}); },
                    {"not empty"});
  const auto file = folder.write("file", "x");
  test::expectError(ErrorCode::RunFailed, [&] { RecordingWriter(file, SourceInfo{}); },
                    {file.string()});
}

TEST(RecordingWriter, RefusesTimeGoingBackwards) {
  const test::TemporaryFolder folder;
  RecordingWriter writer(folder.path(), cameraInfo());
  writer.add(movingObservation(5));
  test::expectError(ErrorCode::RunFailed, [&] { writer.add(movingObservation(4)); },
                    {"frame 4", "frame 5"});
  EXPECT_EQ(openRecording(folder.path()).rows.size(), 1u);
}

TEST(RecordingWriter, TellsToTheBitWhatAReplayGives) {
  const test::TemporaryFolder folder;
  SourceInfo info = cameraInfo();
  info.camera->baseline = 0.1234567890123;
  info.camera->mount.pitch = 1.0 / 3.0;
  info.camera->mount.yaw = -1.0 / 7.0;
  RecordingWriter writer(folder.path(), info);
  writer.add(movingObservation(0));
  const auto source = replay(openRecording(folder.path()), {});
  const StereoCamera& told = writer.info().camera.value();
  const StereoCamera& given = source->info().camera.value();
  EXPECT_EQ(told.fx, given.fx);
  EXPECT_EQ(told.fy, given.fy);
  EXPECT_EQ(told.cx, given.cx);
  EXPECT_EQ(told.cy, given.cy);
  EXPECT_EQ(told.baseline, given.baseline);
  EXPECT_EQ(told.mount.x, given.mount.x);
  EXPECT_EQ(told.mount.y, given.mount.y);
  EXPECT_EQ(told.mount.pitch, given.mount.pitch);
  EXPECT_EQ(told.mount.yaw, given.mount.yaw);
}

TEST(RecordingWriter, APoseAsItIsWrittenReadsBackToTheBit) {
  const test::TemporaryFolder folder;
  std::vector<StampedPose> poses;
  RandomStream random(1);
  for (int i = 0; i < 2000; ++i) {
    poses.push_back({i * 0.1, asWritten({random.uniform(-1e4, 1e4), random.uniform(-1.0, 1.0),
                                         random.uniform(-kPi, kPi)})});
  }
  const Trajectory read = readTum(folder.write("odometry.tum", formatTum(poses)));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    ASSERT_EQ(read.poses()[i].pose, poses[i].pose) << i;
    ASSERT_EQ(read.poses()[i].time_s, poses[i].time_s) << i;
  }
}

// Whatever the moment at which the power goes, and whichever of the two files was ahead.
TEST(RecordingWriter, WhatIsCutOffAnywhereCanBeRead) {
  const test::TemporaryFolder folder;
  {
    RecordingWriter writer(folder.path(), cameraInfo());
    for (int frame = 0; frame < 3; ++frame) writer.add(movingObservation(frame));
  }
  const std::string table = folder.read("frames.csv");
  const std::size_t second_row = table.find('\n', table.find('\n') + 1) + 1;
  for (std::size_t size = second_row; size < table.size(); ++size) {
    folder.write("frames.csv", table.substr(0, size));
    const Recording recording = openRecording(folder.path());
    EXPECT_GE(recording.rows.size(), 1U) << size;
    EXPECT_NO_THROW(replay(recording, {})) << size;
  }
  const std::string odometry = folder.read("odometry.tum");
  folder.write("frames.csv", table.substr(0, second_row));
  for (std::size_t size = odometry.find('\n') + 1; size < odometry.size(); ++size) {
    folder.write("odometry.tum", odometry.substr(0, size));
    EXPECT_NO_THROW(replay(openRecording(folder.path()), {})) << size;
  }
}

}  // namespace
}  // namespace handmap
