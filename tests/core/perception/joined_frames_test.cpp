#include "core/perception/joined_frames.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace handmap {
namespace {

/// Points of the map as a robot has them.
std::vector<RangePoint> seenFrom(const Pose2& robot, const std::vector<Eigen::Vector3d>& map) {
  std::vector<RangePoint> points;
  for (const Eigen::Vector3d& p : map) {
    const Vec2 at = robot.toOwn({p.x(), p.y()});
    points.push_back(
        {static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(p.z()), 1.0F});
  }
  return points;
}

std::vector<Eigen::Vector3d> looks(int count, RandomStream& random) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    points.emplace_back(random.uniform(60.0, 80.0), random.uniform(-10.0, 10.0),
                        random.uniform(0.0, 8.0));
  }
  return points;
}

Pose2 driven(int frame) { return {1.1 * frame, 0.02 * frame * frame, 0.03 * frame}; }

std::size_t left(JoinedFrames& joined, std::vector<RangePoint> points, const Pose2& robot) {
  SeenPoints seen{std::move(points), {}};
  joined.removeRepeats(seen, robot);
  return seen.points.size();
}

TEST(JoinedFrames, EachLookIsGivenOnce) {
  JoinedFrames joined;
  RandomStream random(1);
  std::vector<Eigen::Vector3d> map;
  std::size_t given = 0;
  for (int frame = 0; frame < 30; ++frame) {
    const std::vector<Eigen::Vector3d> fresh = looks(20, random);
    map.insert(map.end(), fresh.begin(), fresh.end());
    const std::size_t from = map.size() > 400 ? map.size() - 400 : 0;
    std::vector<Eigen::Vector3d> frame_points(map.begin() + static_cast<std::ptrdiff_t>(from),
                                              map.end());
    if (frame % 3 == 2) frame_points.erase(frame_points.begin(), frame_points.begin() + 10);
    given += left(joined, seenFrom(driven(frame), frame_points), driven(frame));
  }
  EXPECT_LE(given, map.size() + 100) << "the first few are one return a direction";
}

TEST(JoinedFrames, WhatASensorMeasuresAnewIsKept) {
  JoinedFrames joined;
  RandomStream random(2);
  const std::vector<Eigen::Vector3d> map = looks(500, random);
  for (int frame = 0; frame < 10; ++frame) {
    std::vector<Eigen::Vector3d> measured = map;
    for (Eigen::Vector3d& p : measured) p.x() += random.normal(0.0, 0.02);
    const auto points = seenFrom(driven(frame), measured);
    EXPECT_EQ(left(joined, points, driven(frame)), points.size());
  }
}

TEST(JoinedFrames, AFollowedPointTwiceInOneTellsThatTheyAre) {
  JoinedFrames joined;
  RandomStream random(4);
  const std::vector<Eigen::Vector3d> before = looks(5, random);  // as few as one a direction
  std::vector<Eigen::Vector3d> both = before;
  for (Eigen::Vector3d p : before) both.emplace_back(p + Eigen::Vector3d(0.1, 0.0, 0.0));
  SeenPoints first{seenFrom(driven(0), before), {1, 2, 3, 4, 5}};
  joined.removeRepeats(first, driven(0));
  EXPECT_FALSE(joined.areJoined());
  SeenPoints second{seenFrom(driven(1), both), {1, 2, 3, 4, 5, 1, 2, 3, 0, 0}};
  joined.removeRepeats(second, driven(1));
  EXPECT_TRUE(joined.areJoined());
  EXPECT_EQ(second.points.size(), 5U);
  EXPECT_EQ(second.ids, (std::vector<std::uint32_t>{1, 2, 3, 0, 0}));
}

TEST(JoinedFrames, ARobotThatStandsMaySeeTheSameAgain) {
  JoinedFrames joined;
  RandomStream random(3);
  const auto points = seenFrom({}, looks(100, random));
  for (int frame = 0; frame < 5; ++frame) EXPECT_EQ(left(joined, points, {}), 100U);
  EXPECT_EQ(left(joined, {}, driven(3)), 0U);
}

}  // namespace
}  // namespace handmap
