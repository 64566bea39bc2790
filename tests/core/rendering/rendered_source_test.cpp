#include "core/rendering/rendered_source.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/perception/perception.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/rendering/views.h"

namespace handmap {
namespace {

double distanceToWalls(const Map& map, const Vec2& place) {
  double nearest = 1e9;
  for (const Building& building : map.buildings) {
    const Polygon corners = building.footprint();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      nearest = std::min(nearest,
                         distanceTo(Segment{corners[i], corners[(i + 1) % corners.size()]}, place));
    }
  }
  return nearest;
}

TEST(RenderedSource, DrivesAsTheRangeSourceDoes) {
  const World world = campusWorld(3);
  const auto ranges = simulate(world, {}, 5);
  const auto images = renderedSource(world, {}, test::smallCamera(), Looking::Around, 5);
  const SourceInfo& info = images->info();
  ASSERT_EQ(info.observations, ranges->info().observations);
  for (std::size_t i = 0; i < info.truth.size(); ++i) {
    EXPECT_EQ(info.truth[i].pose, ranges->info().truth[i].pose);
    EXPECT_EQ(info.odometry[i].pose, ranges->info().odometry[i].pose);
    EXPECT_EQ(info.odometry[i].time_s, ranges->info().odometry[i].time_s);
  }
  ASSERT_TRUE(info.camera);
  const Observation first = *images->next();
  const Observation second = *images->next();
  EXPECT_TRUE(first.standing);
  EXPECT_EQ(second.frame, 1);
  EXPECT_EQ(second.odometry, info.odometry[1].pose);
}

TEST(RenderedSource, SixPansLookAllAround) {
  const World world = streetWorld(1);
  const auto source = renderedSource(world, {}, test::smallCamera(), Looking::Around, 1);
  const Observation observation = *source->next();
  ASSERT_EQ(observation.views.size(), 6U);
  for (int degrees = -180; degrees < 180; ++degrees) {
    EXPECT_TRUE(std::any_of(observation.views.begin(), observation.views.end(),
                            [&](const View& view) {
                              return std::abs(normalizedAngle(toRadians(degrees) - view.pan)) <=
                                     toRadians(33.0);
                            }))
        << degrees;
  }
  for (const View& view : observation.views) {
    EXPECT_EQ(view.left.size(), cv::Size(160, 120));
    EXPECT_EQ(view.left.type(), CV_8UC1);
    EXPECT_FALSE(view.points);
  }
}

TEST(RenderedSource, AMovingRobotLooksAhead) {
  SimulationOptions options = atStep({}, 1.0);
  EXPECT_NEAR(options.odometry_heading * std::sqrt(5.0), SimulationOptions{}.odometry_heading,
              1e-12);
  RenderOptions camera = test::smallCamera();
  camera.colour = true;
  int told = 0;
  const auto source =
      renderedSource(test::worldOf({}), options, camera, Looking::Ahead, 1,
                     [&](const Observation& observation, const std::vector<ImageTruth>& truths) {
                       EXPECT_EQ(observation.views.size(), 1U);
                       ASSERT_EQ(truths.size(), 1U);
                       EXPECT_EQ(truths[0].labels.size(), cv::Size(160, 120));
                       ++told;
                     });
  EXPECT_EQ(source->info().observations, 6);
  int count = 0;
  while (const auto observation = source->next()) {
    EXPECT_FALSE(observation->standing);
    EXPECT_EQ(observation->views.front().pan, 0.0);
    EXPECT_EQ(observation->views.front().left.type(), CV_8UC3);
    ++count;
  }
  EXPECT_EQ(count, 6);
  EXPECT_EQ(told, 6);
}

TEST(RenderedSource, RefusesAWorldWithoutAWay) {
  World world;
  test::expectBadInput([&] { renderedSource(world, {}, {}, Looking::Around, 1); }, {"route"});
  test::expectBadInput(
      [&] { renderedSource(test::worldOf({}), atStep({}, 0.0), {}, Looking::Around, 1); },
      {"step"});
}

/// What stereo finds in a panorama of full size between two buildings.
TEST(RenderedSource, PerceptionFindsTheWallsWhereTheyAre) {
  const World world = test::worldOf({test::box("N", {{0.0, 17.0}, 50.0, 14.0, 0.0}),
                                     test::box("S", {{4.0, -18.0}, 40.0, 14.0, 0.0})});
  const auto source = renderedSource(world, {}, {}, Looking::Around, 1);
  Perception perception(source->info(), {});
  const auto percept = perception(*source->next());
  std::vector<double> errors;
  for (const Ray& ray : percept->scan.rays) {
    if (!ray.returned) continue;
    const Vec2 place =
        static_cast<double>(ray.range) * unitVector(static_cast<double>(ray.bearing));
    errors.push_back(distanceToWalls(world.map, place));
  }
  ASSERT_GT(errors.size(), 150U);
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() / 2], 0.2);  // 0.15: sub-pixel locking of the matcher
  EXPECT_LT(errors[errors.size() * 9 / 10], 0.6);
}

}  // namespace
}  // namespace handmap
