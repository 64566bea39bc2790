#include "core/simulation/feature_source.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

namespace handmap {
namespace {

constexpr double kStep_m = 1.14;  // as in boulevard

struct Look {
  std::size_t frame;
  RangePoint point;
  Vec2 place;  ///< map frame, by the true pose
  double distance() const { return std::hypot(point.x, point.y); }
};

struct Drive {
  World world;
  SourceInfo info;
  std::vector<Observation> observations;

  explicit Drive(World its_world, const FeatureOptions& features = {}, std::uint64_t seed = 1,
                 const SimulationOptions& options = drivingPastFeatures(kStep_m))
      : world(std::move(its_world)) {
    const auto source = simulateFeatures(world, options, features, seed);
    info = source->info();
    while (auto observation = source->next()) observations.push_back(std::move(*observation));
  }

  std::map<std::uint32_t, std::vector<Look>> tracks() const {
    std::map<std::uint32_t, std::vector<Look>> result;
    for (std::size_t k = 0; k < observations.size(); ++k) {
      const View& view = observations[k].views.front();
      for (std::size_t i = 0; i < view.ids.size(); ++i) {
        const RangePoint& point = (*view.points)[i];
        result[view.ids[i]].push_back({k, point, info.truth[k].pose.toOuter({point.x, point.y})});
      }
    }
    return result;
  }
};

World kilometre() { return furnished(loopWorld(1), 1); }

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values.at(static_cast<std::size_t>(share * static_cast<double>(values.size())));
}

double toWalls(const World& world, const Vec2& place) {
  double nearest = 1e9;
  for (std::size_t i = 0; i < world.map.buildings.size(); ++i) {
    const Polygon outline = world.wallsOf(i);
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Segment wall{outline[k], outline[(k + 1) % outline.size()]};
      nearest = std::min(nearest, distanceTo(wall, place));
    }
  }
  return nearest;
}

TEST(FeatureSource, FollowsAsManyAsAskedWithStretchesOfFew) {
  const Drive drive(kilometre(), {.tracks = 27.0});
  std::vector<double> counts;
  for (const Observation& observation : drive.observations) {
    const View& view = observation.views.front();
    ASSERT_EQ(view.ids.size(), view.points->size());
    counts.push_back(static_cast<double>(view.ids.size()));
  }
  EXPECT_GT(counts.size(), 800U);
  EXPECT_NEAR(quantile(counts, 0.5), 24.0, 8.0);
  EXPECT_LT(quantile(counts, 0.05), 12.0);
  EXPECT_NEAR(quantile(counts, 0.95), 63.0, 20.0);
}

TEST(FeatureSource, TracksAreAsLongAsBoulevards) {
  std::vector<double> lengths;
  for (const auto& [id, looks] : Drive(kilometre()).tracks()) {
    ASSERT_NE(id, 0U);
    EXPECT_EQ(looks.back().frame - looks.front().frame + 1, looks.size());
    lengths.push_back(static_cast<double>(looks.size()));
  }
  EXPECT_NEAR(quantile(lengths, 0.25), 3.0, 1.0);
  EXPECT_NEAR(quantile(lengths, 0.5), 5.0, 1.0);
  EXPECT_NEAR(quantile(lengths, 0.75), 8.0, 1.5);
  EXPECT_NEAR(quantile(lengths, 0.95), 14.0, 3.0);
}

TEST(FeatureSource, AThirdIsOnWalls) {
  for (const World& world : {kilometre(), streetWorld(2)}) {
    const Drive drive(world);
    int on_walls = 0;
    int all = 0;
    for (const auto& [id, looks] : drive.tracks()) {
      const auto nearest = std::min_element(
          looks.begin(), looks.end(),
          [](const Look& a, const Look& b) { return a.distance() < b.distance(); });
      if (nearest->distance() > 25.0) continue;  // 0.4 m off
      ++all;
      on_walls += toWalls(world, nearest->place) < 0.7 ? 1 : 0;
    }
    EXPECT_GT(all, 300);
    EXPECT_NEAR(static_cast<double>(on_walls) / all, 0.33, 0.08);
  }
}

TEST(FeatureSource, IsOffByTheSquareOfTheDistance) {
  std::map<int, std::vector<double>> off;
  for (const auto& [id, looks] : Drive(kilometre()).tracks()) {
    const auto nearest =
        std::min_element(looks.begin(), looks.end(),
                         [](const Look& a, const Look& b) { return a.distance() < b.distance(); });
    for (const Look& look : looks) {
      if (nearest->distance() > 0.6 * look.distance()) continue;
      const Vec2 ray = look.place - Vec2(nearest->place);
      off[static_cast<int>(look.distance() / 10.0)].push_back(ray.norm() /
                                                              std::pow(look.distance(), 2));
    }
  }
  for (const int tens : {1, 2, 3}) {  // 10 … 40 m; median of a normal's size: 0.67 σ
    ASSERT_GT(off[tens].size(), 50U) << tens;
    EXPECT_NEAR(quantile(off[tens], 0.5) / 0.67, 0.0007, 0.00025) << tens;
  }
}

TEST(FeatureSource, JoinsWhatItSawByItsOdometry) {
  SimulationOptions options = drivingPastFeatures(kStep_m);
  options.odometry_scale = 1.05;
  const Drive drive(kilometre(), {.tracks = 27.0, .joined_m = 40.0}, 1, options);
  const View& before = drive.observations[200].views.front();
  const View& after = drive.observations[201].views.front();
  const Pose2 step = between(drive.observations[201].odometry, drive.observations[200].odometry);
  std::size_t again = 0;
  for (std::size_t i = 0; i < before.ids.size(); ++i) {
    const RangePoint& point = (*before.points)[i];
    EXPECT_GT(point.z, 0.3F);
    EXPECT_LT(std::hypot(point.x, point.y), 35.01);
    const Vec2 moved = step.toOuter({point.x, point.y});
    for (std::size_t k = 0; k < after.ids.size(); ++k) {
      const RangePoint& other = (*after.points)[k];
      if (after.ids[k] != before.ids[i] || other.z != point.z) continue;
      again += (moved - Vec2(other.x, other.y)).norm() < 1e-3 ? 1U : 0U;
    }
  }
  EXPECT_GT(before.ids.size(), 200U);
  EXPECT_GT(again, before.ids.size() * 8 / 10);
  std::vector<std::uint32_t> distinct = before.ids;
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  EXPECT_LT(distinct.size(), before.ids.size() / 2);
}

TEST(FeatureSource, TheSameSeedGivesTheSamePoints) {
  const auto told = [](std::uint64_t seed) {
    std::vector<float> numbers;
    for (const Observation& observation : Drive(streetWorld(1), {}, seed).observations) {
      for (const RangePoint& point : *observation.views.front().points) numbers.push_back(point.x);
    }
    return numbers;
  };
  EXPECT_EQ(told(4), told(4));
  EXPECT_NE(told(4), told(5));
}

}  // namespace
}  // namespace handmap
