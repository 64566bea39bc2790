#include "core/trajectory/track_map.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/trajectory/local_map_odometry.h"
#include "core/trajectory/scan_trajectory.h"

namespace handmap {
namespace {

struct Point {
  Vec2 at;
  float height;
};

std::vector<Point> pointsIn(const Vec2& low, const Vec2& high, int count, RandomStream& random) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    points.push_back({{random.uniform(low.x(), high.x()), random.uniform(low.y(), high.y())},
                      static_cast<float>(random.uniform(0.0, 8.0))});
  }
  return points;
}

/// What a camera that looks ahead sees within 30 m; a point's number is its index and `first`.
std::vector<TrackedPoint> seenFrom(const Pose2& robot, const std::vector<Point>& points,
                                   RandomStream& random, std::uint32_t first = 1) {
  std::vector<TrackedPoint> seen;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 own = robot.toOwn(points[i].at);
    const double range = own.norm();
    if (range < 2.0 || range > 30.0 || std::abs(std::atan2(own.y(), own.x())) > 0.7) continue;
    const double far = 1.0 / (1.0 / range + random.normal(0.0, 0.0003));
    seen.push_back({first + static_cast<std::uint32_t>(i), own * (far / range), points[i].height});
  }
  return seen;
}

MotionPrior odometryOf(const Pose2& from, const Pose2& motion) {
  return {from, WheelNoise().factor(motion)};
}

TEST(TrackMap, TellsThePoseWhereOdometrySlipsAndOthersMove) {
  RandomStream random(1);
  std::vector<Point> points = pointsIn({5.0, -15.0}, {30.0, 15.0}, 60, random);
  TrackMap map;
  map.add(seenFrom({}, points, random), {}, 0.0);
  for (std::size_t i = 0; i < 10; ++i) points[i].at.x() += 1.5;
  const Pose2 now{1.2, 0.05, 0.02};
  const auto match =
      map.match(seenFrom(now, points, random), odometryOf({}, {1.2, 0.6, toRadians(-4.0)}));
  ASSERT_TRUE(match);
  EXPECT_NEAR(match->pose.x, now.x, 0.05);
  EXPECT_NEAR(match->pose.y, now.y, 0.05);
  EXPECT_NEAR(match->pose.heading, now.heading, 0.002);
}

TEST(TrackMap, LeavesItToOdometryWithTwoPoints) {
  RandomStream random(2);
  const std::vector<Point> points = pointsIn({10.0, -3.0}, {20.0, 3.0}, 2, random);
  TrackMap map;
  map.add(seenFrom({}, points, random), {}, 0.0);
  EXPECT_FALSE(map.match(seenFrom({}, points, random), odometryOf({}, {})));
}

TEST(TrackMap, APointThatMovedBeginsAnew) {
  TrackMap map;
  for (const double x : {20.0, 20.02, 25.0}) map.add({{7, {x, 0.0}, 1.0F}}, {}, 0.0);
  EXPECT_EQ(map.refined({{7, {25.0, 0.0}, 1.0F}}, {}).front().at.x(), 25.0);
}

/// A round of 240 m, and 40 m of it again.
std::vector<Pose2> squareDrive() {
  std::vector<Pose2> way;
  for (int i = 0; i < 280; ++i) {
    const int side = i / 60;
    const double along = i % 60;
    const double heading = 0.5 * kPi * side;
    const Pose2 corner{side == 1 || side == 2 ? 60.0 : 0.0, side == 2 || side == 3 ? 60.0 : 0.0,
                       normalizedAngle(heading)};
    way.push_back(corner * Pose2{along, 0.0, 0.0});
  }
  return way;
}

std::vector<RangePoint> asReturns(const std::vector<TrackedPoint>& seen) {
  std::vector<RangePoint> points;
  for (const TrackedPoint& p : seen) {
    points.push_back({static_cast<float>(p.at.x()), static_cast<float>(p.at.y()), p.height, 1.0F});
  }
  return points;
}

std::vector<std::uint32_t> numbersOf(const std::vector<TrackedPoint>& seen) {
  std::vector<std::uint32_t> ids;
  for (const TrackedPoint& p : seen) ids.push_back(p.id);
  return ids;
}

TEST(ScanTrajectory, FollowedPointsTellTheWayAndCloseItsLoop) {
  RandomStream random(3);
  const std::vector<Point> points = pointsIn({-20.0, -20.0}, {80.0, 80.0}, 1200, random);
  const std::vector<Pose2> way = squareDrive();
  ScanTrajectory trajectory({.range_limit_m = 40.0});
  Pose2 odometry = way.front();
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (i > 0) {
      const Pose2 motion = between(way[i - 1], way[i]);
      odometry = odometry * Pose2{1.05 * motion.x, 1.05 * motion.y,
                                  motion.heading + random.normal(0.002, 0.005)};
    }
    // What is met again has another number.
    const auto seen = seenFrom(way[i], points, random, i < 200 ? 1U : 5001U);
    trajectory.add(0.1 * static_cast<double>(i), {odometry, {}}, asReturns(seen), {},
                   numbersOf(seen));
  }
  EXPECT_TRUE(trajectory.isFollowed());
  EXPECT_GT(trajectory.loops(), 0);
  EXPECT_GT((odometry.position() - way.back().position()).norm(), 5.0);
  for (std::size_t i = 0; i < way.size(); i += 20) {
    EXPECT_LT((trajectory.poses()[i].position() - way[i].position()).norm(), 0.5) << i;
  }
}

TEST(LocalMapOdometry, FollowedPointsTellTheMotionWithoutAnyOdometry) {
  RandomStream random(4);
  const std::vector<Point> points = pointsIn({-20.0, -20.0}, {80.0, 80.0}, 1200, random);
  LocalMapOdometry odometry = LocalMapOdometry::ofGuesses();
  Pose2 guess;
  Pose2 before;
  for (int i = 0; i < 40; ++i) {
    const Pose2 pose{0.8 * i, 0.0, 0.0};
    guess = guess * between(before, odometry.pose());  // at the speed of before
    before = odometry.pose();
    EXPECT_EQ(odometry.add(guess, {}, seenFrom(pose, points, random)), i > 0) << i;
  }
  EXPECT_NEAR(odometry.pose().x, 0.8 * 39, 0.3);
  EXPECT_NEAR(odometry.pose().y, 0.0, 0.3);
}

}  // namespace
}  // namespace handmap
