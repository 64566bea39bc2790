#include <gtest/gtest.h>

#include "tests/core/base/expect_error.h"
#include "tests/core/recording/example_recording.h"

namespace handmap {
namespace {

using test::ExampleRecording;
using test::expectBadInput;
using test::framesOf;
using Frames = std::vector<int>;

std::unique_ptr<ObservationSource> open(const ExampleRecording& example,
                                        const ReplayOptions& options = {}) {
  return replay(openRecording(example.path()), options);
}

TEST(Replay, GivesImagesWhereThereAreAny) {
  const ExampleRecording example;
  const auto source = open(example);
  EXPECT_EQ(source->info().name, "Example");
  EXPECT_EQ(source->info().observations, 6);
  EXPECT_EQ(source->info().range_limit_m, 30.0);
  EXPECT_TRUE(source->info().camera);
  EXPECT_EQ(source->info().odometry.size(), 6u);
  EXPECT_EQ(source->info().truth.size(), 2u);
  source->next();
  const auto observation = source->next();
  ASSERT_TRUE(observation);
  EXPECT_EQ(observation->frame, 1);
  EXPECT_EQ(observation->time_s, 11.0);
  EXPECT_FALSE(observation->standing);
  EXPECT_EQ(observation->odometry, (Pose2{1, 0, 0}));
  EXPECT_GT(observation->read_ms, 0.0);
  ASSERT_EQ(observation->views.size(), 1u);
  EXPECT_TRUE(test::sameImage(observation->views[0].left, test::exampleImage(10)));
  EXPECT_TRUE(test::sameImage(observation->views[0].right, test::exampleImage(11)));
  EXPECT_FALSE(observation->views[0].points);
  EXPECT_EQ(framesOf(*source), (Frames{2, 3, 4, 5}));
  EXPECT_FALSE(source->next());
}

TEST(Replay, GivesPointsWhenAsked) {
  const ExampleRecording example;
  const auto source = open(example, {.kind = SourceKind::Points});
  EXPECT_EQ(source->info().observations, 3);
  EXPECT_FALSE(source->info().camera);
  source->next();
  const auto observation = source->next();
  ASSERT_TRUE(observation && observation->views[0].points);
  EXPECT_EQ(observation->frame, 2);
  EXPECT_TRUE(observation->views[0].left.empty());
  EXPECT_EQ(observation->views[0].points->size(), 2u);
  EXPECT_EQ(observation->views[0].points->front().x, 2.0f);
}

TEST(Replay, SeesAsFarAsTheSensorReaches) {
  const ExampleRecording example;
  const auto limitOf = [&](SourceKind kind) {
    return open(example, {.kind = kind})->info().range_limit_m;
  };
  EXPECT_EQ(limitOf(SourceKind::Points), 7.0);  // (4, 5), whole metres; 30 is stated
  EXPECT_EQ(limitOf(SourceKind::Images), 30.0);
  example.folder().write("points/2.bin", test::pointBytes({{60, 0, 1, 1}, {3, 0, 1, 1}}));
  EXPECT_EQ(limitOf(SourceKind::Points), 30.0);
  // What cannot be read is told when it is its turn, not before.
  example.folder().write("points/2.bin", "no points");
  EXPECT_EQ(limitOf(SourceKind::Points), 7.0);
  for (const char* file : {"points/0.bin", "points/2.bin", "points/4.bin"})
    example.folder().write(file, "");
  EXPECT_EQ(limitOf(SourceKind::Points), 30.0);
}

TEST(Replay, AutoTakesPointsWhereThereAreNoImages) {
  const ExampleRecording example;
  example.folder().write("frames.csv", "frame,time_s,points\n0,10,points/0.bin\n");
  const auto source = open(example);
  EXPECT_FALSE(source->info().camera);
  EXPECT_EQ(framesOf(*source), Frames{0});
  expectBadInput([&] { open(example, {.kind = SourceKind::Images}); }, {"no frame with images"});
}

TEST(Replay, SelectsFramesAndEveryNth) {
  const ExampleRecording example;
  EXPECT_EQ(framesOf(*open(example, {.from = 2})), (Frames{2, 3, 4, 5}));
  EXPECT_EQ(framesOf(*open(example, {.from = 1, .to = 3})), (Frames{1, 2, 3}));
  EXPECT_EQ(framesOf(*open(example, {.from = 1, .every = 2})), (Frames{1, 3, 5}));
  // Counts the observations that the source has: of the points frames 0, 2, 4.
  const ReplayOptions points{.every = 2, .kind = SourceKind::Points};
  EXPECT_EQ(framesOf(*open(example, points)), (Frames{0, 4}));
  EXPECT_EQ(open(example, points)->info().observations, 2);
  EXPECT_EQ(open(example, {.from = 1, .to = 3})->info().odometry.size(), 3u);
  expectBadInput([&] { open(example, {.from = 9}); }, {"no frame with images from 9"});
  expectBadInput([&] { open(example, {.from = 4, .to = 2}); }, {"from 4 to 2"});
  test::expectError(ErrorCode::Usage, [&] { open(example, {.every = 0}); }, {"--every", "0"});
}

TEST(Replay, BadFramesAreToldAndPassed) {
  const ExampleRecording example;
  std::filesystem::remove(example.path() / "image_1/1.png");
  example.folder().write("image_0/3.png", "");
  writePng(test::exampleImage(1, 64, 16), example.path() / "image_0/4.png");
  writePng(test::exampleImage(1, 64, 16), example.path() / "image_1/4.png");
  const auto source = open(example);
  EXPECT_EQ(source->info().observations, 6);
  EXPECT_EQ(framesOf(*source), (Frames{0, -1, 2, -3, -4, 5}));

  const auto again = open(example, {.from = 1});
  try {
    again->next();
    ADD_FAILURE() << "no error";
  } catch (const FrameError& error) {
    EXPECT_NE(std::string(error.what()).find("image_1/1.png: found no such file"),
              std::string::npos);
  }
}

TEST(Replay, APairMustHaveOneSize) {
  const ExampleRecording example;
  writePng(test::exampleImage(1, 30, 16), example.path() / "image_1/0.png");
  EXPECT_THROW(open(example)->next(), FrameError);
}

TEST(Replay, BadPointsAreToldAndPassed) {
  const ExampleRecording example;
  example.folder().write("points/2.bin", "123");
  EXPECT_EQ(framesOf(*open(example, {.kind = SourceKind::Points})), (Frames{0, -2, 4}));
}

TEST(Replay, RowsOfOneStopAreOneObservation) {
  const ExampleRecording example;
  example.folder().write("frames.csv",
                         "frame,time_s,stop,pan_deg,points\n"
                         "0,10,1,-90,points/0.bin\n"
                         "1,10.5,1,0,points/2.bin\n"
                         "2,11,1,90,points/4.bin\n"
                         "3,12,2,0,points/0.bin\n"
                         "4,13,,,points/2.bin\n"
                         "5,14,,,points/4.bin\n");
  const auto source = open(example);
  EXPECT_EQ(source->info().observations, 4);
  const auto stop = source->next();
  ASSERT_TRUE(stop);
  EXPECT_TRUE(stop->standing);
  EXPECT_EQ(stop->frame, 0);
  EXPECT_EQ(stop->time_s, 10.0);
  ASSERT_EQ(stop->views.size(), 3u);
  EXPECT_DOUBLE_EQ(stop->views[0].pan, -kPi / 2.0);
  EXPECT_DOUBLE_EQ(stop->views[2].pan, kPi / 2.0);
  EXPECT_EQ(stop->views[2].points->front().x, 4.0f);
  EXPECT_EQ(framesOf(*source), (Frames{3, 4, 5}));
  EXPECT_EQ(framesOf(*open(example, {.every = 2})), (Frames{0, 4}));
  example.folder().write("points/4.bin", "7 bytes");
  EXPECT_EQ(framesOf(*open(example)), (Frames{-0, 3, 4, -5}));
}

TEST(Replay, OdometryMustCoverTheSelection) {
  const ExampleRecording example;
  example.folder().write("odometry.tum", "12.5 0 0 0 0 0 0 1\n14.2 3 0 0 0 0 0 1\n");
  expectBadInput([&] { open(example); },
                 {"frame 0 is at 10 s", "starts late, at 12.5 s", "--from 3"});
  expectBadInput([&] { open(example, {.from = 3}); },
                 {"frame 5 is at 15 s", "ends at 14.2 s", "--to 4"});
  EXPECT_EQ(framesOf(*open(example, {.from = 3, .to = 4})), (Frames{3, 4}));
  example.folder().write("odometry.tum", "100 0 0 0 0 0 0 1\n");
  expectBadInput([&] { open(example); }, {"starts late", "another time"});
  example.folder().write("odometry.tum", "1 0 0 0 0 0 0 1\n");
  expectBadInput([&] { open(example); }, {"ends at 1 s", "another time"});
}

TEST(Replay, OdometryCanBeGivenAndMustBe) {
  const ExampleRecording example;
  ReplayOptions options;
  options.odometry = example.folder().write("other.tum", "10 0 0 0 0 0 0 1\n15 50 0 0 0 0 0 1\n");
  const auto source = open(example, options);
  source->next();
  EXPECT_EQ(source->next()->odometry, (Pose2{10, 0, 0}));
  std::filesystem::remove(example.path() / "odometry.tum");
  expectBadInput([&] { open(example); }, {"no odometry", "--odometry"});
  EXPECT_NO_THROW(open(example, options));
}

TEST(Replay, PlaysTheRealStreet) {
  const std::filesystem::path street = std::filesystem::path(HANDMAP_SHARED_DATA) / "street";
  if (!std::filesystem::exists(street)) GTEST_SKIP() << "no data in " << street;
  const Recording recording = openRecording(street);
  EXPECT_EQ(recording.rows.size(), 399u);
  EXPECT_NEAR(recording.camera->baseline, 0.5372, 1e-4);
  const auto images = replay(recording, {.from = 40, .every = 60});
  EXPECT_EQ(images->info().observations, 7);
  const auto observation = images->next();
  EXPECT_EQ(observation->frame, 40);
  EXPECT_EQ(observation->views[0].left.size(), cv::Size(1242, 375));
  EXPECT_EQ(observation->views[0].right.type(), CV_8UC1);
  EXPECT_EQ(framesOf(*images), (Frames{100, 160, 220, 280, 340, 400}));
  const auto points = replay(recording, {.kind = SourceKind::Points});
  EXPECT_EQ(points->info().observations, 57);
  EXPECT_EQ(points->next()->views[0].points->size(), 496512u / 16u);
  const auto later = replay(recording, {.from = 40, .kind = SourceKind::Points});
  EXPECT_GE(later->next()->frame, 40);
}

TEST(Replay, PlaysTheRealKittiFolder) {
  const auto folder = std::filesystem::path(HANDMAP_SHARED_DATA) / "kitti-odometry-06";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no data in " << folder;
  const Recording recording = openRecording(folder);
  EXPECT_EQ(recording.name, "kitti-odometry-06");
  EXPECT_EQ(recording.rows.size(), 21u);
  EXPECT_EQ(recording.truth.poses().size(), 21u);
  const auto source = replay(recording, {.every = 10});
  EXPECT_EQ(framesOf(*source), (Frames{0, 10, 20}));
  const Pose2 odometry_end = recording.odometry.poses().back().pose;
  const Pose2 truth_end = recording.truth.poses().back().pose;
  EXPECT_GT(truth_end.x, 20.0);  // a drive straight ahead, and both agree on it
  EXPECT_LT((odometry_end.position() - truth_end.position()).norm(), 1.0);
  EXPECT_NEAR(odometry_end.heading, truth_end.heading, 0.05);
}

}  // namespace
}  // namespace handmap
