// A drive through a yard of posts, around a bend, of which anything may be wrong.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/base/random.h"
#include "tests/core/recording/example_recording.h"

namespace handmap::test {

/// What may be changed of it.
struct YardDrive {
  std::function<Pose2(int)> way = [](int i) {
    const double turn = 0.04 * i;
    return Pose2{12.0 * std::sin(turn), 12.0 * (1.0 - std::cos(turn)), turn};
  };
  std::function<RangePoint(const RangePoint&)> point = [](const RangePoint& p) { return p; };
  std::function<StampedPose(const StampedPose&)> pose = [](const StampedPose& p) { return p; };
  std::function<double(double)> time = [](double time_s) { return time_s; };
  std::function<bool(int)> has_pose = [](int) { return true; };
  std::function<bool(int)> has_points = [](int) { return true; };
  std::function<int(int)> file = [](int i) { return i; };  ///< the points file of a row
  std::string json = R"("range_limit_m": 40)";
};

/// Writes it there; not yet opened.
inline void writeYardDrive(const TemporaryFolder& folder, const YardDrive& drive) {
  RandomStream random(7);
  std::vector<Vec2> posts;
  for (int i = 0; i < 300; ++i) {
    const double y = random.uniform(-40, 50);  // first on every compiler: the page tells figures
    posts.emplace_back(random.uniform(-30, 60), y);
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
    const auto name = [](int file) { return "points/" + std::to_string(file) + ".bin"; };
    if (drive.has_points(i)) folder.write(name(i), pointBytes(points));
    table += fmt::format("{},{},{}\n", i, drive.time(0.5 * i), name(drive.file(i)));
  }
  folder.write("recording.json",
               R"({"format": "handmap-recording", "version": 1, )" + drive.json + "}");
  folder.write("frames.csv", table);
  folder.write("odometry.tum", formatTum(poses));
}

inline Recording recorded(const TemporaryFolder& folder, const YardDrive& drive) {
  writeYardDrive(folder, drive);
  return openRecording(folder.path());
}

}  // namespace handmap::test
