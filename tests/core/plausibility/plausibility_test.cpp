// Right recordings are believed, wrong ones are doubted for their cause, and the remedy cures them.
#include "core/plausibility/plausibility.h"

#include <functional>

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/plausibility/drawing.h"
#include "tests/core/recording/example_recording.h"

namespace handmap {
namespace {

/// What may be changed of a drive through a yard of posts, around a bend.
struct Drive {
  std::function<Pose2(int)> way = [](int i) {
    const double turn = 0.04 * i;
    return Pose2{12.0 * std::sin(turn), 12.0 * (1.0 - std::cos(turn)), turn};
  };
  std::function<RangePoint(const RangePoint&)> point = [](const RangePoint& p) { return p; };
  std::function<StampedPose(const StampedPose&)> pose = [](const StampedPose& p) { return p; };
  std::function<double(double)> time = [](double time_s) { return time_s; };
  std::function<bool(int)> has_pose = [](int) { return true; };
  std::function<bool(int)> has_points = [](int) { return true; };
  std::string json = R"("range_limit_m": 40)";
};

class Plausibility : public testing::Test {
 protected:
  Recording recorded(const Drive& drive) const {
    RandomStream random(7);
    std::vector<Vec2> posts;
    for (int i = 0; i < 300; ++i) {
      posts.emplace_back(random.uniform(-30, 60), random.uniform(-40, 50));
    }
    std::string table = "frame,time_s,points\n";
    std::vector<StampedPose> poses;
    for (int i = 0; i < 60; ++i) {
      const Pose2 pose = drive.way(i);
      if (drive.has_pose(i)) poses.push_back(drive.pose({drive.time(0.5 * i), pose}));
      std::vector<RangePoint> points;
      for (const Vec2& post : posts) {
        const Vec2 own = pose.toOwn(post);
        if (own.norm() > 25.0) continue;
        points.push_back(
            drive.point({static_cast<float>(own.x()), static_cast<float>(own.y()), 0.0F, 1.0F}));
      }
      const std::string name = "points/" + std::to_string(i) + ".bin";
      if (drive.has_points(i)) folder_.write(name, test::pointBytes(points));
      table += fmt::format("{},{},{}\n", i, drive.time(0.5 * i), name);
    }
    folder_.write("recording.json",
                  R"({"format": "handmap-recording", "version": 1, )" + drive.json + "}");
    folder_.write("frames.csv", table);
    folder_.write("odometry.tum", formatTum(poses));
    return openRecording(folder_.path());
  }

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

Drive withPoints(float xx, float xy, float yx, float yy, float raise_m = 0.0F) {
  Drive drive;
  drive.point = [=](const RangePoint& p) {
    return RangePoint{xx * p.x + xy * p.y, yx * p.x + yy * p.y, p.z + raise_m, 1.0F};
  };
  return drive;
}

Drive withPoses(double scale, double sign, double turn) {
  Drive drive;
  drive.pose = [=](const StampedPose& p) {
    return StampedPose{p.time_s,
                       {scale * p.pose.x, scale * p.pose.y, sign * p.pose.heading + turn}};
  };
  return drive;
}

Drive withTimes(double scale) {
  Drive drive;
  drive.time = [scale](double time_s) { return scale * time_s; };
  return drive;
}

TEST_F(Plausibility, ARightRecordingIsBelieved) { EXPECT_TRUE(doubtsOf(recorded({})).empty()); }

TEST_F(Plausibility, Units) {
  expectDoubt(recorded(withPoints(1000, 0, 0, 1000)), "points_units", true, "millimetres");
  expectDoubt(recorded(withPoints(100, 0, 0, 100)), "points_units", true, "centimetres");
  expectDoubt(recorded(withPoses(1000, 1, 0)), "odometry_units", true, "millimetres",
              "odometry.tum: line 2");
  expectDoubt(recorded(withPoses(100, 1, 0)), "odometry_units", false, "centimetres");
  expectDoubt(recorded(withTimes(1e9)), "time_units", true, "nanoseconds", "frames.csv: line 3");
  expectDoubt(recorded(withTimes(1e3)), "time_units", false, "milliseconds");
}

TEST_F(Plausibility, OfAnotherFileOfOdometryThanTheRecordings) {
  Recording recording = recorded(withPoses(1000, 1, 0));
  std::filesystem::rename(folder_.path() / "odometry.tum", folder_.path() / "mine.tum");
  recording.odometry = readTum(folder_.path() / "mine.tum");
  expectDoubt(recording, "odometry_units", true, "millimetres", "mine.tum: line 2");
}

TEST_F(Plausibility, Axes) {
  expectDoubt(recorded(withPoints(1, 0, 0, -1)), "opposite_turns", false, "upside down",
              "frames.csv: line 2");
  expectDoubt(recorded(withPoints(0, -1, 1, 0)), "points_axes", false, "x right, y forward");
  expectDoubt(recorded(withPoints(-1, 0, 0, -1)), "points_axes", false, "x backwards");
  const float half = std::sqrt(0.5F);
  expectDoubt(recorded(withPoints(half, -half, half, half)), "points_axes", false, "by -45°");
  expectDoubt(recorded(withPoints(0, 1, -1, 0)), "points_axes", false, "by 90°");
  expectDoubt(recorded(withPoses(1, 1, -kPi / 2)), "odometry_heading", false, "counted from y",
              "odometry.tum: line 2");
  expectDoubt(recorded(withPoses(1, -1, 0)), "odometry_heading", false, "clockwise");
  expectDoubt(recorded(withPoses(1, 0, 0)), "odometry_heading", false, "w comes first");
}

/// Along a street, never more than 11° to either side.
TEST_F(Plausibility, AWayThatHardlyBends) {
  const auto weaving = [](Drive drive) {
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
    Drive drive;
    drive.point = [spread](const RangePoint& p) {
      const double bearing = spread * std::atan2(p.y, p.x);
      const double range_m = std::hypot(p.x, p.y);
      return RangePoint{static_cast<float>(range_m * std::cos(bearing)),
                        static_cast<float>(range_m * std::sin(bearing)), p.z, 1.0F};
    };
    expectDoubt(recorded(drive), "ray_directions", false, "field of view", "frames.csv: line 2");
  }
}

TEST_F(Plausibility, Clocks) {
  Drive drive;
  drive.pose = [](const StampedPose& p) { return StampedPose{p.time_s + 1.7e9, p.pose}; };
  expectDoubt(recorded(drive), "two_clocks", true, "two clocks", "odometry.tum: line 1");
  drive.pose = [](const StampedPose& p) { return StampedPose{1e3 * p.time_s, p.pose}; };
  expectDoubt(recorded(drive), "two_clocks", true, "the odometry looks like milliseconds");
}

TEST_F(Plausibility, WhatIsMissing) {
  Drive drive;
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

TEST_F(Plausibility, RangeLimitAndKeys) {
  Drive drive;
  drive.json = R"("range_limit_m": 12)";
  expectDoubt(recorded(drive), "range_limit", false, "\"range_limit_m\": 30");
  drive.json = R"("range_limit": 40)";
  const Doubts doubts = doubtsOf(recorded(drive));
  ASSERT_EQ(doubts.size(), 1U);
  EXPECT_EQ(doubts[0].code, "strange_key");
  EXPECT_NE(doubts[0].message.find("range_limit: found a key that nothing knows, expected "
                                   "range_limit_m"),
            std::string::npos);
}

TEST_F(Plausibility, HeightsThatWereNotRaised) {
  Drive drive;
  int number = 0;
  drive.point = [&number](const RangePoint& p) {
    return RangePoint{p.x, p.y, ++number % 3 == 0 ? 0.5F : -1.7F, 1.0F};
  };
  expectDoubt(recorded(drive), "heights", false, "1.7 m");
}

TEST_F(Plausibility, NoPointCounts) {
  Drive drive;
  drive.point = [](const RangePoint& p) { return RangePoint{p.x, p.y, p.z, 0.0F}; };
  expectDoubt(recorded(drive), "likelihood_zero", true, "w is 1");
}

/// One building inside of the bend, one outside.
Map yard(double scale, double y_sign) {
  Map map;
  map.start = Pose2{0, 0, 0};
  map.buildings.resize(2);
  map.buildings[0].id = "A";
  map.buildings[0].shape = Rectangle{{0, y_sign * scale * 36}, scale * 44, scale * 52, 0};
  map.buildings[1].id = "B";
  map.buildings[1].shape = Rectangle{{scale * 30, y_sign * scale * -25}, scale * 60, scale * 30, 0};
  return map;
}

TEST_F(Plausibility, OfADrawing) {
  EXPECT_TRUE(doubtsOfDrawing(yard(1, 1), "m").empty());
  ASSERT_EQ(doubtsOfDrawing(yard(1000, 1), "m").size(), 1U);
  EXPECT_EQ(doubtsOfDrawing(yard(1000, 1), "m")[0].hint, "these look like millimetres");
  EXPECT_EQ(doubtsOfDrawing(yard(1000, 1), "m")[0].message.find("m: buildings[0]: found half"), 0U);
  Map misspelt = yard(1, 1);
  misspelt.buildings[0].unknown["fixd"] = "true";
  ASSERT_EQ(doubtsOfDrawing(misspelt, "m").size(), 1U);
  EXPECT_EQ(doubtsOfDrawing(misspelt, "m")[0].message,
            "m: building A: fixd: found a key that nothing knows, expected fixed");
}

/// The way is clear of buildings either way; what is seen are the walls of one side.
TEST_F(Plausibility, ADrawingWhoseMirrorImageIsSeen) {
  std::string table = "frame,time_s,points\n";
  std::vector<StampedPose> poses;
  for (int i = 0; i < 50; ++i) {
    const double x = 1.5 * i;
    poses.push_back({1.0 * i, {x, 0.0, 0.0}});
    std::vector<RangePoint> points;
    for (int wall = -15; wall < 90; ++wall) {
      if (std::abs(wall - x) < 20.0 && wall % 30 < 18) {
        points.push_back({static_cast<float>(wall - x), 6.0F, 0.5F, 1.0F});
      }
    }
    const std::string name = "points/" + std::to_string(i) + ".bin";
    folder_.write(name, test::pointBytes(points));
    table += fmt::format("{},{},{}\n", i, i, name);
  }
  folder_.write("recording.json", R"({"format": "handmap-recording", "version": 1})");
  folder_.write("frames.csv", table);
  folder_.write("odometry.tum", formatTum(poses));
  const Recording recording = openRecording(folder_.path());
  const auto street = [](double y_sign) {
    Map map;
    map.start = Pose2{0, 0, 0};
    map.buildings.resize(3);
    for (int i = 0; i < 3; ++i) {
      map.buildings[static_cast<std::size_t>(i)].shape =
          Rectangle{{30.0 * i + 9.0, y_sign * 12.0}, 20.0, 10.0, 0.0};
    }
    return map;
  };
  EXPECT_TRUE(doubtsOfWay(recording, street(1), "m").empty());
  const Doubts doubts = doubtsOfWay(recording, street(-1), "m");
  ASSERT_EQ(doubts.size(), 1U);
  EXPECT_EQ(doubts[0].code, "mirrored_drawing");
  EXPECT_EQ(doubts[0].message.find("m: buildings: found what is seen "), 0U) << doubts[0].message;
}

TEST_F(Plausibility, AWayThroughBuildingsThatMirroredKeepsClear) {
  Drive drive;
  drive.pose = [](const StampedPose& p) {
    return StampedPose{p.time_s, {3 * p.pose.x, 3 * p.pose.y, p.pose.heading}};
  };
  const Recording recording = recorded(drive);
  EXPECT_TRUE(doubtsOfWay(recording, yard(1, 1), "m").empty());
  const Doubts doubts = doubtsOfWay(recording, yard(1, -1), "m");
  ASSERT_EQ(doubts.size(), 1U);
  EXPECT_EQ(doubts[0].code, "way_through_buildings");
}

}  // namespace
}  // namespace handmap
