// Right recordings are believed, wrong ones are doubted for their cause, and the remedy cures them.
#include "core/plausibility/plausibility.h"

#include <functional>

#include <gtest/gtest.h>

#include "tests/core/plausibility/yard_drive.h"

namespace handmap {
namespace {

using test::YardDrive;

class Plausibility : public testing::Test {
 protected:
  Recording recorded(const YardDrive& drive) const { return test::recorded(folder_, drive); }

  /// The only doubt there is has this code; its remedy, where it has one, leaves none.
  static void expectDoubt(const Recording& recording, const std::string& code, bool certain,
                          const std::string& hint, const std::string& place = {}) {
    const Doubts doubts = doubtsOf(recording);
    ASSERT_EQ(doubts.size(), 1U) << (doubts.empty() ? "none" : doubts[1].message);
    EXPECT_EQ(doubts[0].code, code);
    EXPECT_EQ(doubts[0].certain, certain);
    EXPECT_NE(doubts[0].hint.find(hint), std::string::npos) << doubts[0].hint;
    EXPECT_NE(doubts[0].message.find(place + ": "), std::string::npos) << doubts[0].message;
    if (!doubts[0].remedy) return;
    const Doubts left = doubtsOf(remedied(recording, *doubts[0].remedy));
    EXPECT_TRUE(left.empty()) << left[0].message;
  }

  test::TemporaryFolder folder_;
};

YardDrive withPoints(float xx, float xy, float yx, float yy, float raise_m = 0.0F) {
  YardDrive drive;
  drive.point = [=](const RangePoint& p) {
    return RangePoint{xx * p.x + xy * p.y, yx * p.x + yy * p.y, p.z + raise_m, 1.0F};
  };
  return drive;
}

YardDrive withPoses(double scale, double sign, double turn) {
  YardDrive drive;
  drive.pose = [=](const StampedPose& p) {
    return StampedPose{p.time_s,
                       {scale * p.pose.x, scale * p.pose.y, sign * p.pose.heading + turn}};
  };
  return drive;
}

TEST_F(Plausibility, ARightRecordingIsBelieved) { EXPECT_TRUE(doubtsOf(recorded({})).empty()); }

TEST_F(Plausibility, OfAnotherFileOfOdometryThanTheRecordings) {
  Recording recording = recorded(withPoses(1000, 1, 0));
  std::filesystem::rename(folder_.path() / "odometry.tum", folder_.path() / "mine.tum");
  recording.odometry = readTum(folder_.path() / "mine.tum");
  expectDoubt(recording, "odometry_units", true, "millimetres", "mine.tum: line 2");
}

/// Along a street, never more than 11° to either side.
TEST_F(Plausibility, AWayThatHardlyBends) {
  const auto weaving = [](YardDrive drive) {
    drive.way = [](int i) {
      const double x = 0.8 * i;
      return Pose2{x, 3.0 * std::sin(x / 15.0), std::atan(0.2 * std::cos(x / 15.0))};
    };
    return drive;
  };
  EXPECT_TRUE(doubtsOf(recorded(weaving({}))).empty());
  expectDoubt(recorded(weaving(withPoints(1, 0, 0, -1))), "opposite_turns", false, "upside down");
  expectDoubt(recorded(weaving(withPoses(1, -1, 0))), "odometry_heading", false, "clockwise");
}

TEST_F(Plausibility, AnotherFieldOfView) {
  for (const double spread : {2.0 / 3.0, 4.0 / 3.0}) {
    YardDrive drive;
    drive.point = [spread](const RangePoint& p) {
      const double bearing = spread * std::atan2(p.y, p.x);
      const double range_m = std::hypot(p.x, p.y);
      return RangePoint{static_cast<float>(range_m * std::cos(bearing)),
                        static_cast<float>(range_m * std::sin(bearing)), p.z, 1.0F};
    };
    expectDoubt(recorded(drive), "ray_directions", false, "field of view", "frames.csv: line 2");
  }
}

TEST_F(Plausibility, WhatIsMissing) {
  YardDrive drive;
  drive.has_pose = [](int i) { return i < 20 || i > 35; };
  expectDoubt(recorded(drive), "odometry_gaps", false, "straight at one speed",
              "odometry.tum: line 21: found gaps with frames in them");
  drive = {};
  drive.has_points = [](int i) { return i % 2 == 0; };
  for (int i = 1; i < 60; i += 2) {
    std::filesystem::remove(folder_.path() / ("points/" + std::to_string(i) + ".bin"));
  }
  expectDoubt(recorded(drive), "points_missing", false, "copied whole",
              "frames.csv: line 3: points");
}

TEST_F(Plausibility, AScannerThatFroze) {
  const Recording recording = recorded({});
  const auto scan = [&](int i) { return folder_.path() / fmt::format("points/{}.bin", i); };
  for (int i = 41; i < 50; ++i) {
    std::filesystem::copy_file(scan(40), scan(i),
                               std::filesystem::copy_options::overwrite_existing);
  }
  expectDoubt(recording, "scans_repeated", false, "did the scanner freeze",
              "frames.csv: line 43: points");
  EXPECT_NE(doubtsOf(recording)[0].message.find("so 9 of 59 looked at"), std::string::npos)
      << doubtsOf(recording)[0].message;
}

}  // namespace
}  // namespace handmap
