#include "core/fastslam/fastslam_psom.h"

#include <atomic>
#include <cmath>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/core/fastslam/direct_fastslam.h"

namespace handmap {
namespace {

Building rectangle(const std::string& id, double x, double y, double width, double depth) {
  Building building;
  building.id = id;
  building.shape = Rectangle{{x, y}, width, depth, 0.0};
  return building;
}

/// A street with two houses on either side; the robot starts between them and looks along +x.
Map street() {
  Map map;
  map.start = Pose2{0.0, 0.0, 0.0};
  map.uncertainty = {1.5, 1.5};
  map.buildings = {rectangle("N1", 0.0, 14.0, 16.0, 10.0), rectangle("N2", 26.0, 14.0, 20.0, 10.0),
                   rectangle("S1", 2.0, -13.0, 20.0, 8.0), rectangle("S2", 28.0, -13.0, 16.0, 8.0)};
  return map;
}

/// What a sensor without noise would see of the walls that face the robot.
LocalMap seen(const Map& truth, const Pose2& robot) {
  std::vector<WallPoint> points;
  for (const Building& building : truth.buildings) {
    const Polygon corners = building.footprint();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 a = robot.toOwn(corners[i]);
      const Vec2 b = robot.toOwn(corners[(i + 1) % corners.size()]);
      if (cross(a, b) >= 0.0) continue;
      for (double s = 0.0; s < (b - a).norm(); s += 0.05) {
        const Vec2 p = a + (b - a).normalized() * s;
        points.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), 0.05F, 1.0F});
      }
    }
  }
  return LocalMapBuilder(40.0, LocalMapOptions{}).add(robot, true, points);
}

double errorSum(const Map& map, const Map& truth) {
  double sum = 0.0;
  for (std::size_t b = 0; b < truth.buildings.size(); ++b) {
    const Rectangle found = map.buildings[b].box();
    const Rectangle real = truth.buildings[b].box();
    sum += (found.centre - real.centre).cwiseAbs().sum() + std::abs(found.width - real.width);
  }
  return sum;
}

Map drawnWrong(Map map) {
  const double shifts[][3] = {
      {1.2, -0.8, 1.5}, {-1.5, 1.0, -1.2}, {0.9, 1.1, 1.0}, {1.4, -1.0, -1.5}};
  for (std::size_t b = 0; b < map.buildings.size(); ++b) {
    Rectangle box = map.buildings[b].box();
    box.centre += Vec2(shifts[b][0], shifts[b][1]);
    box.width += shifts[b][2];
    map.buildings[b] = map.buildings[b].fitted(box);
  }
  return map;
}

SlamOptions few() {
  SlamOptions options;
  options.slam_particles = 20;
  return options;
}

std::string bytesOf(const FastSlamPsom& slam) {
  std::string bytes;
  const auto append = [&](double value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (const Particle& particle : slam.particles()) {
    for (const double value :
         {particle.pose.x, particle.pose.y, particle.pose.heading, particle.weight}) {
      append(value);
    }
    for (std::size_t b = 0; b < 5; ++b) {
      const Swarm* swarm = particle.map.find(b);
      if (swarm == nullptr) continue;
      for (const float width : swarm->positions(Swarm::Width)) append(static_cast<double>(width));
    }
  }
  return bytes;
}

std::string bytesOfRun(int threads) {
  FastSlamPsom slam(drawnWrong(street()), {}, few(), 4);
  Arena arena(threads);
  for (int i = 0; i < 4; ++i) {
    const Pose2 pose{4.0 * i, 0.0, 0.0};
    const LocalMap local_map = seen(street(), pose);
    arena.execute([&] { slam.step(i, pose, local_map); });
  }
  return bytesOf(slam);
}

/// Rms of where the particles are, x and y, after a step in which nothing is seen.
Vec2 spreadAfter(const Eigen::Matrix3d& guessed) {
  SlamOptions many;
  many.slam_particles = 500;
  FastSlamPsom slam(street(), {}, many, 1);
  slam.step(0.0, {}, seen({}, {}));
  slam.step(1.0, {{4.0, 0.0, 0.0}, guessed}, seen({}, {}));
  Vec2 squares = Vec2::Zero();
  for (const Particle& particle : slam.particles())
    squares += particle.weight * (particle.pose.position() - Vec2(4.0, 0.0)).cwiseAbs2();
  return squares.cwiseSqrt();
}

TEST(FastSlamPsom, AGuessedMotionIsAsUnsureAsAGuess) {
  const Vec2 measured = spreadAfter(Eigen::Matrix3d::Zero());
  EXPECT_LT(measured.maxCoeff(), 0.5);
  Eigen::Matrix3d along = Eigen::Matrix3d::Zero();
  along(0, 0) = 4.0;
  const Vec2 guessed = spreadAfter(along);
  EXPECT_NEAR(guessed.x(), 2.0, 0.3);
  EXPECT_NEAR(guessed.y(), measured.y(), 0.1);
}

TEST(FastSlamPsom, CorrectsTheDrawing) {
  const Map truth = street();
  const Map drawing = drawnWrong(truth);
  FastSlamPsom slam(drawing, {}, few(), 1);
  for (int i = 0; i < 7; ++i) {
    const Pose2 pose{4.0 * i, 0.0, 0.0};
    ASSERT_TRUE(slam.step(i, pose, seen(truth, pose)));
  }
  const Map refined = slam.refinedMap();
  EXPECT_LT(errorSum(refined, truth), 0.5 * errorSum(drawing, truth));
  for (const Building& building : refined.buildings) {
    ASSERT_TRUE(building.estimate);
    EXPECT_EQ(building.estimate->observations, 7);
  }
  EXPECT_EQ(slam.best().path.poses().size(), 7U);
}

TEST(FastSlamPsom, OnAFixedMapLocalizesBetterThanOdometry) {
  SlamOptions options = few();
  options.slam_particles = 300;
  options.refine = false;
  options.motion = {0.1, 0.01, 0.05, 0.01, 0.001};
  FastSlamPsom slam(street(), {}, options, 2);
  Pose2 odometry;
  Pose2 pose;
  for (int i = 0; i < 10; ++i) {
    if (i > 0) {
      pose = pose * Pose2{3.0, 0.0, 0.0};
      odometry = odometry * Pose2{3.3, 0.0, 0.01};
    }
    slam.step(i, odometry, seen(street(), pose));
  }
  const double odometry_error = (odometry.position() - pose.position()).norm();
  EXPECT_LT((slam.best().pose.position() - pose.position()).norm(), odometry_error / 2.5);
  for (std::size_t b = 0; b < 4; ++b) {
    EXPECT_EQ(slam.refinedMap().buildings[b].shape, street().buildings[b].shape);
  }
}

TEST(FastSlamPsom, AFixedBuildingStays) {
  Map drawing = drawnWrong(street());
  drawing.buildings[1].fixed = true;
  FastSlamPsom slam(drawing, {}, few(), 3);
  slam.step(0.0, {}, seen(street(), {}));
  EXPECT_EQ(slam.refinedMap().buildings[1].shape, drawing.buildings[1].shape);
  EXPECT_NE(slam.refinedMap().buildings[0].shape, drawing.buildings[0].shape);
}

TEST(FastSlamPsom, TheNumberOfThreadsChangesNothing) {
  const std::string one = bytesOfRun(1);
  EXPECT_EQ(one, bytesOfRun(2));
  EXPECT_EQ(one, bytesOfRun(4));
}

TEST(FastSlamPsom, DoesWhatThePlainFormOfTheAlgorithmDoes) {
  // The same random numbers; only walls are read to half a cell. So they part slowly, and only
  // where swarms are chaotic: all seeds together end equally near the truth.
  double fast_error = 0.0;
  double plain_error = 0.0;
  const Map truth = street();
  const Map drawing = drawnWrong(truth);
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    FastSlamPsom fast(drawing, {}, few(), seed);
    test::DirectFastSlam plain(drawing, {}, few(), seed);
    for (int i = 0; i < 7; ++i) {
      const Pose2 pose{4.0 * i, 0.0, 0.0};
      const LocalMap local_map = seen(truth, pose);
      fast.step(i, pose, local_map);
      plain.step(pose, local_map);
      EXPECT_NEAR(fast.best().pose.x, plain.meanPose().x, 0.5);
      EXPECT_NEAR(fast.best().pose.y, plain.meanPose().y, 0.3);
      EXPECT_NEAR(fast.best().pose.heading, plain.meanPose().heading, 0.03);
    }
    Map found = drawing;
    for (std::size_t b = 0; b < 4; ++b) {
      found.buildings[b] =
          found.buildings[b].fitted(BuildingModel(drawing.buildings[b]).box(plain.best(b)));
    }
    fast_error += errorSum(fast.refinedMap(), truth);
    plain_error += errorSum(found, truth);
  }
  EXPECT_NEAR(fast_error, plain_error, 0.3 * plain_error);
}

TEST(FastSlamPsom, BuildingsOutOfSightChangeNothing) {
  Map crowded = drawnWrong(street());
  for (int i = 0; i < 2000; ++i) {
    crowded.buildings.push_back(rectangle("F" + std::to_string(i), 200.0 + 30.0 * (i % 50),
                                          30.0 * std::floor(i / 50.0), 20.0, 10.0));
  }
  FastSlamPsom alone(drawnWrong(street()), {}, few(), 4);
  FastSlamPsom among(crowded, {}, few(), 4);
  for (int i = 0; i < 4; ++i) {
    const Pose2 pose{4.0 * i, 0.0, 0.0};
    alone.step(i, pose, seen(street(), pose));
    among.step(i, pose, seen(street(), pose));
  }
  EXPECT_EQ(bytesOf(alone), bytesOf(among));
}

TEST(FastSlamPsom, ASwarmThatWentFarFromItsDrawingIsStillSeen) {
  // It stands 35 m beside its drawing, which is out of range of the last poses.
  Map drawing = street();
  drawing.buildings.resize(1);
  drawing.uncertainty = {40.0, 0.1};
  Map truth = drawing;
  Rectangle box = truth.buildings[0].box();
  box.centre.x() += 35.0;
  truth.buildings[0].shape = box;
  SlamOptions options = few();
  options.pso_particles = 300;
  options.motion = {0.0, 0.0, 0.0, 0.0, 0.0};
  FastSlamPsom slam(drawing, {}, options, 8);
  for (int i = 0; i < 12; ++i) {
    const Pose2 pose{5.0 * i, 0.0, 0.0};
    slam.step(i, pose, seen(truth, pose));
  }
  EXPECT_GT(slam.refinedMap().buildings[0].box().centre.x(), 30.0);
  EXPECT_EQ(slam.lastStep().visible_buildings, 1);
}

TEST(FastSlamPsom, CancelledInsideAStepTheStateIsTheOneBefore) {
  FastSlamPsom slam(drawnWrong(street()), {}, few(), 5);
  slam.step(0.0, {}, seen(street(), {}));
  const std::string before = bytesOf(slam);
  std::stop_source stop;
  std::atomic<int> calls = 0;
  const bool done = slam.step(1.0, Pose2{4.0, 0.0, 0.0}, seen(street(), {4.0, 0.0, 0.0}),
                              stop.get_token(), [&](double) {
                                ++calls;
                                stop.request_stop();
                              });
  EXPECT_FALSE(done);
  EXPECT_GE(calls.load(), 1);
  EXPECT_LT(calls.load(), 20);
  EXPECT_EQ(bytesOf(slam), before);
}

TEST(FastSlamPsom, ParticlesInsideABuildingAreRefused) {
  // The robot drives at a fixed wall: particles that the noise puts behind it must not survive.
  Map drawing = street();
  drawing.buildings.push_back(rectangle("E", 10.0, 0.0, 4.0, 10.0));
  for (Building& building : drawing.buildings) building.fixed = true;
  SlamOptions options = few();
  options.slam_particles = 200;
  options.resample_below = 1.1;
  options.motion = {0.3, 0.0, 0.0, 0.0, 0.0};
  FastSlamPsom slam(drawing, {}, options, 6);
  slam.step(0.0, {}, seen(drawing, {}));
  slam.step(1.0, Pose2{7.0, 0.0, 0.0}, seen(drawing, {7.0, 0.0, 0.0}));
  const Polygon wall = drawing.buildings.back().footprint();
  for (const Particle& particle : slam.particles()) {
    EXPECT_FALSE(contains(wall, particle.pose.position())) << particle.pose.x;
  }
}

TEST(FastSlamPsom, RefusesAMapWithoutBuildingsOrStart) {
  EXPECT_THROW(FastSlamPsom(Map{}, {}, {}, 1), Error);
  Map map = street();
  map.start.reset();
  EXPECT_THROW(FastSlamPsom(map, {}, {}, 1), Error);
}

TEST(Path, LongPathsAreReleasedWithoutRecursion) {
  Path path;
  for (int i = 0; i < 500000; ++i) path = path.extended({static_cast<double>(i), {}});
  EXPECT_EQ(path.poses().size(), 500000U);
}

TEST(FastSlamPsom, ParticlesOfAStartThatIsNotSureLieAsItMayLie) {
  Map map = street();
  SlamOptions options;
  options.slam_particles = 4000;
  const FastSlamPsom sure(map, {}, options, 1);
  for (const Particle& particle : sure.particles()) EXPECT_EQ(particle.pose, *map.start);
  map.start_uncertainty = StartUncertainty{2.0, toRadians(10.0)};
  const FastSlamPsom slam(map, {}, options, 1);
  EXPECT_EQ(slam.particles().front().pose, *map.start);
  double squares = 0.0;
  double turns = 0.0;
  for (const Particle& particle : slam.particles()) {
    squares += particle.pose.position().squaredNorm();
    turns += particle.pose.heading * particle.pose.heading;
  }
  EXPECT_NEAR(std::sqrt(squares / options.slam_particles), 2.0 * std::sqrt(2.0), 0.15);
  EXPECT_NEAR(toDegrees(std::sqrt(turns / options.slam_particles)), 10.0, 0.5);
}

}  // namespace
}  // namespace handmap
