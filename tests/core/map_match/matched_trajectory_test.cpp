#include "core/map_match/matched_trajectory.h"

#include <gtest/gtest.h>

#include "core/perception/perception.h"
#include "core/simulation/simulated_source.h"

namespace handmap {
namespace {

struct Drive {
  std::vector<Pose2> trajectory;  ///< as the wheels tell it
  std::vector<Pose2> truth;
  std::vector<Percept> percepts;
  double range_limit_m = 0.0;
};

Drive drive(const World& world) {
  const auto source = simulate(world, laserOnTheMove(1.0), 5);
  Drive drive;
  drive.range_limit_m = source->info().range_limit_m;
  Perception perception(source->info(), {});
  while (const auto observation = source->next()) {
    drive.truth.push_back(source->info().truth[drive.trajectory.size()].pose);
    drive.trajectory.push_back(observation->odometry);
    drive.percepts.push_back(*perception(*observation));
  }
  return drive;
}

struct Localized {
  std::vector<Pose2> live;
  std::vector<Pose2> poses;
  double sigma_m = 0.0;
  int visible = 0;
};

Localized localize(const Map& map, const Drive& drive, const std::stop_token& stop = {}) {
  SeenFrames seen(drive.range_limit_m);
  MatchedTrajectory matched(map, seen);
  Localized localized;
  std::vector<Pose2> trajectory;
  for (std::size_t i = 0; i < drive.trajectory.size(); ++i) {
    trajectory.push_back(drive.trajectory[i]);
    seen.add(i, drive.trajectory[i], drive.percepts[i].scan, drive.percepts[i].points);
    matched.add(trajectory, kWheels);
    localized.live.push_back(matched.pose());
    localized.visible = std::max(localized.visible, matched.visibleBuildings());
  }
  matched.finish(stop);
  localized.poses = matched.poses();
  localized.sigma_m = std::sqrt(matched.covariance().topLeftCorner<2, 2>().trace());
  return localized;
}

double farthest(const std::vector<Pose2>& poses, const std::vector<Pose2>& truth,
                std::size_t from = 0) {
  double most = 0.0;
  for (std::size_t i = from; i < poses.size(); ++i) {
    most = std::max(most, (poses[i].position() - truth[i].position()).norm());
  }
  return most;
}

TEST(MatchedTrajectory, KeepsToTheWallsWhereTheWheelsDrift) {
  const World world = twoRowWorld(17);
  const Drive drive = handmap::drive(world);
  std::vector<Pose2> wheels;
  for (const Pose2& pose : drive.trajectory) wheels.push_back(*world.map.start * pose);
  ASSERT_GT(farthest(wheels, drive.truth), 1.0);
  const Localized localized = localize(world.map, drive);
  ASSERT_EQ(localized.poses.size(), drive.truth.size());
  EXPECT_LT(farthest(localized.poses, drive.truth), 1.0);
  EXPECT_LT(farthest(localized.live, drive.truth), 1.5);
  EXPECT_LT(localized.sigma_m, 1.0);
  EXPECT_GE(localized.visible, 2);
}

TEST(MatchedTrajectory, FindsOutThatTheStartIsOff) {
  const World world = twoRowWorld(18);
  const Drive drive = handmap::drive(world);
  Map map = world.map;
  map.start = *map.start * Pose2{0.3, 0.5, toRadians(2.0)};
  const Localized localized = localize(map, drive);
  ASSERT_GT((map.start->position() - world.map.start->position()).norm(), 0.5);
  EXPECT_LT(farthest({localized.poses.front()}, {drive.truth.front()}), 0.5);
  EXPECT_LT(farthest(localized.poses, drive.truth, 10), 1.0);
}

TEST(MatchedTrajectory, GoesOnByItsOwnWayWhereNoWallIsInSight) {
  const World world = twoRowWorld(17);
  const Drive drive = handmap::drive(world);
  Map elsewhere = world.map;
  for (Building& building : elsewhere.buildings) {
    Rectangle box = building.box();
    box.centre.y() += 1000.0;
    building.shape = box;
  }
  const Localized localized = localize(elsewhere, drive);
  std::vector<Pose2> wheels;
  for (const Pose2& pose : drive.trajectory) wheels.push_back(*world.map.start * pose);
  EXPECT_LT(farthest(localized.poses, wheels), 1e-6);
  EXPECT_EQ(localized.visible, 0);
  // And it says so: walls would have made it surer than a metre.
  EXPECT_GT(localized.sigma_m, 1.0);
}

TEST(MatchedTrajectory, LaysAWholeWayAtOnce) {
  const World world = twoRowWorld(17);
  const Drive drive = handmap::drive(world);
  SeenFrames seen(drive.range_limit_m);
  for (std::size_t i = 0; i < drive.trajectory.size(); ++i) {
    seen.add(i, drive.trajectory[i], drive.percepts[i].scan, drive.percepts[i].points);
  }
  MatchedTrajectory matched(world.map, seen);
  matched.lay(drive.trajectory, kWheels, {});
  EXPECT_LT(farthest(matched.poses(), localize(world.map, drive).poses), 0.1);
  EXPECT_LT(farthest(matched.poses(), drive.truth), 1.0);
}

TEST(MatchedTrajectory, StopsWhenAsked) {
  const World world = twoRowWorld(17);
  const Drive drive = handmap::drive(world);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(localize(world.map, drive, stop.get_token()).poses.size(), drive.truth.size());
}

}  // namespace
}  // namespace handmap
