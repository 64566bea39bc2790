#include "core/recording/trajectory.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "tests/core/base/comma_locale.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/base/temporary_folder.h"

namespace handmap {
namespace {

using test::expectBadInput;
using test::TemporaryFolder;

TEST(Trajectory, InterpolatesAndKeepsToItsEnds) {
  const Trajectory trajectory({{1.0, {0, 0, toRadians(170)}}, {3.0, {4, 2, toRadians(-170)}}}, "t");
  const auto middle = trajectory.at(2.0);
  ASSERT_TRUE(middle);
  EXPECT_DOUBLE_EQ(middle->x, 2.0);
  EXPECT_DOUBLE_EQ(middle->y, 1.0);
  EXPECT_NEAR(std::abs(middle->heading), kPi, 1e-12);
  EXPECT_EQ(trajectory.at(1.0), (Pose2{0, 0, toRadians(170)}));
  EXPECT_EQ(trajectory.at(3.0), (Pose2{4, 2, toRadians(-170)}));
  EXPECT_EQ(trajectory.at(0.96), trajectory.at(1.0));
  EXPECT_EQ(trajectory.at(3.04), trajectory.at(3.0));
  EXPECT_FALSE(trajectory.at(0.94));
  EXPECT_FALSE(trajectory.at(3.06));
  EXPECT_TRUE(trajectory.at(0.5, 0.5));
  EXPECT_FALSE(trajectory.at(std::nan("")));
  EXPECT_FALSE(Trajectory().at(0.0));
}

TEST(Trajectory, TimeMustIncrease) {
  expectBadInput(
      [] {
        Trajectory({{1.0, {}}, {2.0, {}}, {2.0, {}}}, "vo");
      },
      {"vo: pose 2", "time 2 after 2"});
}

TEST(Tum, ReadsCommentsAndTakesYawOfTheWholeQuaternion) {
  const TemporaryFolder folder;
  // Roll of 30° first, then yaw of 40°.
  const double r = toRadians(15.0);
  const double y = toRadians(20.0);
  const std::string turned = std::to_string(std::cos(y) * std::sin(r)) + " " +
                             std::to_string(std::sin(y) * std::sin(r)) + " " +
                             std::to_string(std::sin(y) * std::cos(r)) + " " +
                             std::to_string(std::cos(y) * std::cos(r));
  const auto path = folder.write("t.tum", "# head\n\n1.5 1 2 9 0 0 1 0\r\n2.5\t3 4 9 " + turned);
  const auto poses = readTum(path).poses();
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[0].time_s, 1.5);
  EXPECT_EQ(poses[0].pose, (Pose2{1, 2, kPi}));
  EXPECT_NEAR(poses[1].pose.heading, toRadians(40.0), 1e-5);
}

TEST(Tum, RefusesBadLinesNamingThem) {
  const TemporaryFolder folder;
  const auto refuse = [&](const std::string& content, const std::vector<std::string>& words) {
    const auto path = folder.write("t.tum", content);
    expectBadInput([&] { readTum(path); }, words);
  };
  const std::string good = "1 0 0 0 0 0 0 1\n";
  refuse("", {"t.tum", "no pose"});
  refuse("# only comments\n", {"no pose"});
  refuse(good + "2 0 0 0 0 0 0\n", {"t.tum: line 2", "7 fields"});
  refuse(good + "2 0 0 0 0 0 0 1 5\n", {"line 2", "9 fields"});
  refuse(good + "2 nan 0 0 0 0 0 1\n", {"line 2", "\"nan\""});
  refuse(good + "2 1e300 0 0 0 0 0 1\n", {"line 2", "1e300"});
  refuse(good + "2 1,5 0 0 0 0 0 1\n", {"line 2", "1,5"});
  refuse(good + "2 0 0 0 0 0 0 0\n", {"line 2", "quaternion of length 0"});
  refuse(good + "2 0 0 0 0 0 1 1\n", {"line 2", "quaternion"});
  refuse(good + "# c\n0.5 0 0 0 0 0 0 1\n", {"line 3", "time 0.5 after 1"});
  refuse(good + good, {"line 2", "time 1 after 1"});
  expectBadInput([&] { readTum(folder.path() / "none"); }, {"none", "no such file"});
}

TEST(Tum, WrittenPosesReadBack) {
  const TemporaryFolder folder;
  RandomStream random(1);
  std::vector<StampedPose> poses;
  for (int i = 0; i < 200; ++i) {
    poses.push_back({1.7e9 + 0.1 * i + 1e-3 * random.uniform(),
                     {random.normal(0, 100), random.normal(0, 100), random.uniform(-kPi, kPi)}});
  }
  const test::CommaLocale comma;
  const auto again = readTum(folder.write("t.tum", formatTum(poses))).poses();
  ASSERT_EQ(again.size(), poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(again[i].time_s, poses[i].time_s);
    EXPECT_NEAR(again[i].pose.x, poses[i].pose.x, 1e-6);
    EXPECT_NEAR(again[i].pose.y, poses[i].pose.y, 1e-6);
    EXPECT_NEAR(normalizedAngle(again[i].pose.heading - poses[i].pose.heading), 0.0, 1e-8);
  }
  EXPECT_EQ(formatTum({{1.5, {1, 2, kPi}}}),
            "1.5 1.000000 2.000000 0 0 0 1.000000000 0.000000000\n");
}

TEST(Trajectory, AQuaternionWithWFirstIsRefused) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("a.tum", "0 0 0 0 1 0 0 0\n1 1 0 0 0.995 0 0 0.0998\n");
  test::expectBadInput([&] { readTum(path); },
                       {"a.tum: line 1", "tips the robot over, as 2 of 2 do", "is w the first"});
}

TEST(Trajectory, TimesInNanosecondsAreNamed) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("a.tum", "1700000000000000000 0 0 0 0 0 0 1\n");
  test::expectBadInput([&] { readTum(path); }, {"a.tum: line 1", "this looks like nanoseconds"});
}

}  // namespace
}  // namespace handmap
