#include "core/recording/recording.h"

#include <gtest/gtest.h>

#include "core/recording/kitti_folder.h"
#include "core/recording/validation.h"
#include "tests/core/base/comma_locale.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/recording/example_recording.h"

namespace handmap {
namespace {

using test::ExampleRecording;
using test::expectBadInput;
using test::TemporaryFolder;

TEST(Recording, OpensTheFolder) {
  const ExampleRecording example;
  const Recording recording = openRecording(example.path());
  EXPECT_EQ(recording.name, "Example");
  EXPECT_EQ(recording.range_limit_m, 30.0);
  ASSERT_TRUE(recording.camera);
  EXPECT_DOUBLE_EQ(recording.camera->baseline, 0.5);
  EXPECT_EQ(recording.camera->mount.x, 0.1);
  EXPECT_EQ(recording.camera->mount.y, 0.2);
  EXPECT_EQ(recording.camera->mount.z, 1.5);
  EXPECT_DOUBLE_EQ(recording.camera->mount.pitch, toRadians(3));
  EXPECT_DOUBLE_EQ(recording.camera->mount.yaw, toRadians(4));
  EXPECT_EQ(recording.rows.size(), 6u);
  EXPECT_EQ(recording.odometry.poses().size(), 6u);
  EXPECT_EQ(recording.truth.poses().size(), 2u);
}

TEST(Recording, NeedsOnlyFormatAndVersion) {
  const ExampleRecording example;
  example.folder().write("recording.json", R"({"format": "handmap-recording", "version": 1})");
  const Recording recording = openRecording(example.path());
  EXPECT_EQ(recording.name, example.path().filename().string());
  EXPECT_EQ(recording.range_limit_m, 40.0);
  ASSERT_TRUE(recording.camera);  // there are images, so calib.txt and P0, P1 are taken
  EXPECT_EQ(recording.camera->mount.z, 1.65);

  example.folder().write("frames.csv", "frame,time_s,points\n0,10,points/0.bin\n");
  EXPECT_FALSE(openRecording(example.path()).camera);
}

TEST(Recording, RefusesBadDescriptions) {
  const ExampleRecording example;
  const auto refuse = [&](const std::string& members, const std::vector<std::string>& words) {
    example.folder().write("recording.json", "{" + members + "}");
    expectBadInput([&] { openRecording(example.path()); }, words);
  };
  const std::string head = R"("format": "handmap-recording", "version": 1)";
  refuse("", {"recording.json: format: found nothing"});
  refuse(R"("format": "handmap", "version": 1)", {"format: found \"handmap\""});
  refuse(R"("format": "handmap-recording", "version": 3)",
         {"recording.json: version: found 3", "up to 2", "update the program"});
  refuse(R"("format": "handmap-recording", "version": "1")", {"version: found \"1\""});
  refuse(head + R"(, "range_limit_m": 0.5)", {"range_limit_m: found 0.5"});
  refuse(head + R"(, "range_limit_m": 10000)",
         {"recording.json: range_limit_m: found 10000, expected a number from 1 to 200"});
  refuse(head + R"(, "camera": [])", {"camera: found an array"});
  refuse(head + R"(, "camera": {"mount": {"z_m": "high"}})", {"camera.mount.z_m: found \"high\""});
  refuse(head + R"(, "camera": {"left": "P7"})", {"calib.txt", "no line P7"});
  refuse(head + R"(, "camera": {"calibration": "../calib.txt"})", {"camera.calibration", "inside"});
  refuse(head + R"(, "camera": {"calibration": "none.txt"})", {"none.txt", "no such file"});
  refuse(head + R"(, "camera": {"rectified": false})", {"camera.calibration", "nothing"});
  refuse(head + R"(, "camera": {"rectified": false, "calibration": "calib.txt"})",
         {"camera.calibration", "\"rectified\" is false"});
  refuse(head + R"(, "camera": {"rectified": true, "calibration": "stereo.yml"})",
         {"camera.calibration", "\"rectified\" is true"});
  refuse(head + R"(, "camera": {"calibration": "stereo.yaml"})", {"stereo.yaml", "no such file"});
  refuse(head + ", oops", {"recording.json: line 1", "no valid JSON"});
}

TEST(Recording, RefusesWhatIsNoRecording) {
  const TemporaryFolder folder;
  expectBadInput([&] { openRecording(folder.path() / "none"); }, {"none", "no such folder"});
  expectBadInput([&] { openRecording(folder.path()); }, {"neither recording.json nor"});
  const auto file = folder.write("file", "x");
  expectBadInput([&] { openRecording(file); }, {"file", "no such folder"});
  folder.write("recording.json", R"({"format": "handmap-recording", "version": 1})");
  expectBadInput([&] { openRecording(folder.path()); }, {"frames.csv", "no such file"});
}

TEST(Recording, DoesNotFollowTheLocale) {
  const ExampleRecording example;
  const test::CommaLocale comma;
  const Recording recording = openRecording(example.path());
  EXPECT_EQ(recording.camera->mount.z, 1.5);
  EXPECT_EQ(recording.rows[3].time_s, 13.0);
}

TEST(Validation, FindsEveryProblem) {
  const ExampleRecording example;
  EXPECT_TRUE(problemsOf(openRecording(example.path())).empty());
  std::filesystem::remove(example.path() / "image_0/1.png");
  example.folder().write("image_1/2.png", "");
  example.folder().write("points/4.bin", "short");
  example.folder().write("odometry.tum", "10 0 0 0 0 0 0 1\n14 0 0 0 0 0 0 1\n");
  const auto problems = problemsOf(openRecording(example.path()));
  ASSERT_EQ(problems.size(), 4u);
  EXPECT_NE(problems[0].find("frame 1: "), std::string::npos);
  EXPECT_NE(problems[0].find("image_0/1.png"), std::string::npos);
  EXPECT_NE(problems[1].find("frame 2: "), std::string::npos);
  EXPECT_NE(problems[2].find("frame 4: "), std::string::npos);
  EXPECT_NE(problems[2].find("5 bytes"), std::string::npos);
  EXPECT_NE(problems[3].find("frame 5: no odometry"), std::string::npos);
}

// ---- KITTI folders

class Kitti : public ::testing::Test {
 protected:
  Kitti() {
    folder_.write("times.txt", "0.0\n1.0e-01\n2.0e-01\n");
    folder_.write("calib.txt",
                  "P2: 700 0 16 70 0 700 8 0 0 0 1 0\n"
                  "P3: 700 0 16 -280 0 700 8 0 0 0 1 0\n");
    for (const char* camera : {"image_2", "image_3"}) {
      for (const char* name : {"000000.png", "000001.png", "000002.png"}) {
        std::filesystem::create_directories(folder_.path() / camera);
        writePng(test::exampleImage(1), folder_.path() / camera / name);
      }
    }
  }

  TemporaryFolder folder_;
  // One metre ahead; then one to the right of that, looking right. Starts turned and far away.
  const std::string poses_ =
      "0 0 1 5 0 1 0 7 -1 0 0 9\n"
      "0 0 1 6 0 1 0 7 -1 0 0 9\n"
      "-1 0 0 6 0 1 0 7 0 0 -1 8\n";
};

TEST_F(Kitti, OpensColourPairs) {
  folder_.write("odometry_kitti.txt", poses_);
  const Recording recording = openRecording(folder_.path());
  ASSERT_EQ(recording.rows.size(), 3u);
  EXPECT_EQ(recording.rows[2].frame, 2);
  EXPECT_EQ(recording.rows[2].time_s, 0.2);
  EXPECT_EQ(recording.rows[2].left, "image_2/000002.png");
  EXPECT_EQ(recording.rows[2].right, "image_3/000002.png");
  EXPECT_EQ(recording.camera->mount.z, 1.65);
  EXPECT_NEAR(recording.camera->mount.y, 0.1, 1e-12);
  EXPECT_EQ(test::framesOf(*replay(recording, {})), (std::vector<int>{0, 1, 2}));
}

TEST_F(Kitti, TurnsPosesIntoTheRobotFrame) {
  const auto path = folder_.write("odometry_kitti.txt", poses_);
  const auto poses = readKittiPoses(path, {0.0, 1.0, 2.0}).poses();
  ASSERT_EQ(poses.size(), 3u);
  EXPECT_EQ(poses[0].pose, Pose2{});
  EXPECT_NEAR(poses[1].pose.x, 1.0, 1e-12);
  EXPECT_NEAR(poses[1].pose.y, 0.0, 1e-12);
  EXPECT_NEAR(poses[1].pose.heading, 0.0, 1e-12);
  EXPECT_NEAR(poses[2].pose.x, 1.0, 1e-12);
  EXPECT_NEAR(poses[2].pose.y, -1.0, 1e-12);
  EXPECT_NEAR(poses[2].pose.heading, -kPi / 2.0, 1e-12);
}

TEST_F(Kitti, TruthIsNeverOdometry) {
  folder_.write("poses_gt_kitti.txt", poses_);
  const Recording recording = openRecording(folder_.path());
  EXPECT_EQ(recording.truth.poses().size(), 3u);
  EXPECT_TRUE(recording.odometry.empty());
  expectBadInput([&] { replay(recording, {}); }, {"no odometry", "--odometry FILE.tum"});
  ReplayOptions options;
  options.odometry = folder_.write("my.tum", "0 0 0 0 0 0 0 1\n0.2 1 0 0 0 0 0 1\n");
  EXPECT_EQ(replay(recording, options)->info().odometry.size(), 2u);
}

TEST_F(Kitti, RefusesBadFiles) {
  folder_.write("poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  expectBadInput([&] { openRecording(folder_.path()); }, {"poses.txt", "1 poses", "3"});
  const auto row = [](const std::string& middle) {
    return "1 0 0 0 0 1 0 0 0 0 1 0\n" + middle + "\n1 0 0 0 0 1 0 0 0 0 1 0\n";
  };
  folder_.write("poses.txt", row("1 0 0"));
  expectBadInput([&] { openRecording(folder_.path()); }, {"poses.txt: line 2", "3 numbers"});
  folder_.write("poses.txt", row("1 0 0 0 0 1 0 0 0 0 nan 0"));
  expectBadInput([&] { openRecording(folder_.path()); }, {"line 2", "nan"});
  folder_.write("poses.txt", row("2 0 0 0 0 1 0 0 0 0 1 0"));
  expectBadInput([&] { openRecording(folder_.path()); }, {"line 2", "rotation"});
  folder_.write("times.txt", "0\n1\n0.5\n");
  expectBadInput([&] { openRecording(folder_.path()); }, {"times.txt: line 3", "0.5 after 1"});
  folder_.write("times.txt", "0\nx\n");
  expectBadInput([&] { openRecording(folder_.path()); }, {"times.txt: line 2", "\"x\""});
  std::filesystem::remove_all(folder_.path() / "image_3");
  expectBadInput([&] { openRecording(folder_.path()); }, {"image_3", "no images"});
}

}  // namespace
}  // namespace handmap
