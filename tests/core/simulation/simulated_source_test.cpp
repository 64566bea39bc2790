#include "core/simulation/simulated_source.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

std::vector<Observation> all(ObservationSource& source) {
  std::vector<Observation> observations;
  while (auto observation = source.next()) observations.push_back(std::move(*observation));
  return observations;
}

/// No noise and nothing unrecognised.
SimulationOptions exact() {
  SimulationOptions options;
  options.sigma_offset_m = options.sigma_quadratic = 0.0;
  options.outliers = options.unrecognised = options.obstacles_mistaken = 0.0;
  options.odometry_length = options.odometry_heading = 0.0;
  return options;
}

/// Walls 20 m away on four sides.
World squareRoom() {
  World room;
  Building building;
  building.id = "Ring";
  building.shape = Polygon{{-20, -20}, {20, -20}, {20, 20}, {-20, 20}};
  room.map.buildings = {building};
  room.map.start = Pose2{};
  room.map.route = {{0, 0}, {0.1, 0}};
  return room;
}

TEST(SimulatedSource, StepsAlongTheRouteFromTheStart) {
  const World world = campusWorld(3);
  const auto source = simulate(world, {}, 1);
  const SourceInfo& info = source->info();
  const std::vector<Observation> observations = all(*source);
  ASSERT_EQ(static_cast<int>(observations.size()), info.observations);
  ASSERT_EQ(info.truth.size(), observations.size());
  EXPECT_EQ(info.truth.front().pose, *world.map.start);
  EXPECT_EQ(observations.front().odometry, Pose2{});
  for (std::size_t i = 1; i < observations.size(); ++i) {
    EXPECT_TRUE(observations[i].standing);
    EXPECT_DOUBLE_EQ(observations[i].time_s, 5.0 * static_cast<double>(i));
    const Pose2 step = between(info.truth[i - 1].pose, info.truth[i].pose);
    EXPECT_NEAR(step.position().norm(), 5.0, 1.5);
    const Pose2 reported = between(observations[i - 1].odometry, observations[i].odometry);
    EXPECT_NEAR(reported.position().norm() / step.position().norm(), 1.0, 0.2);
    EXPECT_NEAR(reported.heading, step.heading, 0.06);
  }
}

TEST(SimulatedSource, LooksNoFartherAroundThanItsView) {
  SimulationOptions options;
  options.view_rad = kPi;
  const auto source = simulate(twoRowWorld(1), options, 1);
  for (const Observation& observation : all(*source)) {
    ASSERT_FALSE(observation.views.front().points->empty());
    for (const RangePoint& point : *observation.views.front().points) EXPECT_GE(point.x, -1e-4F);
  }
}

TEST(SimulatedSource, WithoutNoiseEveryPointLiesOnATrueSurface) {
  const World world = campusWorld(2);
  const auto source = simulate(world, exact(), 1);
  std::size_t trees = 0;
  const std::vector<Observation> observations = all(*source);
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const Pose2 truth = source->info().truth[i].pose;
    EXPECT_NEAR(
        (observations[i].odometry.position() - world.map.start->toOwn(truth.position())).norm(),
        0.0, 1e-6);
    for (const RangePoint& point : *observations[i].views.front().points) {
      const Vec2 place = truth.toOuter({point.x, point.y});
      double off = 1e9;
      if (point.w == 1.0F) {
        for (const Building& building : world.map.buildings) {
          const Polygon corners = building.footprint();
          for (std::size_t k = 0; k < corners.size(); ++k) {
            off = std::min(
                off, distanceTo(Segment{corners[k], corners[(k + 1) % corners.size()]}, place));
          }
        }
      } else {
        ++trees;
        for (const Obstacle& tree : world.obstacles) {
          off = std::min(off, std::abs((tree.centre - place).norm() - tree.radius));
        }
      }
      ASSERT_LT(off, 1e-4);
      ASSERT_LE(std::hypot(point.x, point.y), 40.001);
    }
  }
  EXPECT_GT(trees, 100U);
}

TEST(SimulatedSource, ThingsAsHighAsTheSensorAreNoWalls) {
  World world;
  world.map.start = Pose2{};
  world.map.route = {{0, 0}, {0.1, 0}};
  world.things = {{Thing::Kind::Car, {{10.0, 0.0}, 4.0, 1.8, 0.0}, 1.5},
                  {Thing::Kind::Hedge, {{0.0, 10.0}, 4.0, 1.0, 0.0}, 0.8}};
  const auto source = simulate(world, exact(), 1);
  const Observation observation = *source->next();
  int on_car = 0;
  for (const RangePoint& point : *observation.views.front().points) {
    EXPECT_EQ(point.w, 0.0F);
    EXPECT_NEAR(point.x, 8.0F, 1e-4F);  // the hedge is lower than the sensor
    EXPECT_LE(std::abs(point.y), 0.9F);
    ++on_car;
  }
  EXPECT_GT(on_car, 20);
}

TEST(SimulatedSource, SoftThingsLetAShareOfTheRaysThrough) {
  World world = squareRoom();
  const double free_path = 0.5;
  world.things = {{Thing::Kind::Fence, {{10.0, 0.0}, 1.0, 30.0, 0.0}, 1.5, free_path}};
  world.obstacles = {{{-10.0, 0.0}, 4.0, free_path}};
  SimulationOptions options = exact();
  options.rays = 40000;
  const auto source = simulate(world, options, 3);
  const Observation observation = *source->next();
  double stopped = 0.0;
  double expected = 0.0;
  int straight = 0;
  double depths = 0.0;
  for (const RangePoint& point : *observation.views.front().points) {
    const double distance = std::hypot(point.x, point.y);
    const double bearing = std::atan2(point.y, point.x);
    if (point.x > 0.0F && std::abs(bearing) < 0.5) {
      expected += 1.0 - std::exp(-1.0 / std::cos(bearing) / free_path);
      stopped += point.w == 0.0F ? 1.0 : 0.0;
      if (point.w > 0.0F) {
        EXPECT_NEAR(point.x, 20.0F, 1e-3F);
        continue;
      }
      EXPECT_GE(point.x, 9.499F);
      EXPECT_LE(point.x, 10.501F);
      ++straight;
      depths += static_cast<double>(point.x) - 9.5;
    } else if (point.w == 0.0F && point.x < 0.0F) {
      EXPECT_LE((Vec2(point.x, point.y) - Vec2(-10.0, 0.0)).norm(), 4.001);
      EXPECT_GT(distance, 5.99);
    }
  }
  EXPECT_NEAR(stopped / expected, 1.0, 0.03);
  // The mean of an exponential law that is cut off at one metre.
  const double through = std::exp(-1.0 / free_path);
  EXPECT_NEAR(depths / straight, free_path - through / (1.0 - through), 0.02);
}

TEST(SimulatedSource, ReturnsAreLostWithTheSquareOfTheDistance) {
  SimulationOptions options = losingReturns(exact());
  options.rays = 40000;
  const auto source = simulate(squareRoom(), options, 3);
  double expected = 0.0;
  for (int ray = 0; ray < options.rays; ++ray) {
    const Vec2 direction = unitVector(2.0 * kPi * ray / options.rays);
    const double share = 20.0 / direction.cwiseAbs().maxCoeff() / options.range_limit_m;
    expected += 1.0 - options.lost * share * share;
  }
  const Observation observation = *source->next();
  EXPECT_NEAR(static_cast<double>(observation.views.front().points->size()) / expected, 1.0, 0.01);
}

TEST(SimulatedSource, SeesTheWallsThatAWorldHasInPlaceOfTheMap) {
  World world = squareRoom();
  world.walls = {
      Polygon{{-20, -20}, {20, -20}, {20, -1}, {21, -1}, {21, 1}, {20, 1}, {20, 20}, {-20, 20}}};
  const auto source = simulate(world, exact(), 3);
  const Observation observation = *source->next();
  EXPECT_NEAR(observation.views.front().points->front().x, 21.0F, 1e-4F);
}

TEST(SimulatedSource, NoiseIsWhatTheOptionsSay) {
  const World room = squareRoom();
  SimulationOptions options;
  options.rays = 40000;
  const auto source = simulate(room, options, 5);
  const Observation observation = *source->next();
  double squares = 0.0;
  int close = 0;
  int recognised = 0;
  int count = 0;
  for (const RangePoint& point : *observation.views.front().points) {
    ++count;
    recognised += point.w == 1.0F ? 1 : 0;
    const double bearing = std::atan2(point.y, point.x);
    const double distance =
        20.0 / std::max(std::abs(std::cos(bearing)), std::abs(std::sin(bearing)));
    const double sigma = options.sigma_offset_m + options.sigma_quadratic * distance * distance;
    const double error = (std::hypot(point.x, point.y) - distance) / sigma;
    EXPECT_FLOAT_EQ(point.z, 1.0F);
    if (std::abs(error) > 4.0) continue;
    ++close;
    squares += error * error;
  }
  EXPECT_EQ(count, 40000);
  EXPECT_NEAR(std::sqrt(squares / close), 1.0, 0.02);
  EXPECT_NEAR(1.0 - close / 40000.0, 0.02 * 0.75, 0.005);  // the rest of the outliers falls near
  EXPECT_NEAR(recognised / 40000.0, 0.85, 0.01);
}

TEST(SimulatedSource, FollowsFromItsSeed) {
  const World world = twoRowWorld(1);
  const auto points = [&](std::uint64_t seed) {
    std::vector<float> values;
    for (const Observation& observation : all(*simulate(world, {}, seed))) {
      values.push_back(static_cast<float>(observation.odometry.x));
      for (const RangePoint& point : *observation.views.front().points) {
        values.insert(values.end(), {point.x, point.y, point.w});
      }
    }
    return values;
  };
  EXPECT_EQ(points(1), points(1));
  EXPECT_NE(points(1), points(2));
}

}  // namespace
}  // namespace handmap
