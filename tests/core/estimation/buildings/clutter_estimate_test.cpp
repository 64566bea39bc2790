#include "core/estimation/buildings/clutter_estimate.h"

#include <gtest/gtest.h>

#include "tests/core/estimation/scene.h"

namespace handmap {
namespace {

/// A robot that passes a wall of 40 m, 10 m away, with free space beside it.
class ClutterTest : public testing::Test {
 protected:
  /// `change` may shorten a ray that came back.
  template <typename Change>
  Clutter measured(Change change) {
    ClutterEstimate estimate;
    for (int i = 0; i < 60; ++i) {
      Frame frame = seenFrom({-30.0 + i, 0.0, 0.0}, {found_.box}, 0.1, random_);
      for (FrameRay& ray : frame.rays) change(ray.sight);
      estimate.add(frame, {&found_, 1}, sensor_);
    }
    return estimate.measured();
  }
  void shorten(Sight& sight, double share) {
    if (random_.uniform() < share) sight.range *= static_cast<float>(random_.uniform());
  }

  FoundBox found_{Box{{0.0, 10.0}, 0.0, {20.0, 8.0, 20.0, 0.0}}};
  SensorModel sensor_{MeasuredSensor{}, 40.0};
  RandomStream random_{1, 0, 0, 0};
};

TEST_F(ClutterTest, ThereIsNone) {
  const Clutter clutter = measured([](Sight&) {});
  EXPECT_LT(clutter.wall_like_per_m, 0.001);
  EXPECT_LT(clutter.others_per_m, 0.001);
  EXPECT_LT(clutter.at_walls, 1.1);
}

TEST_F(ClutterTest, FalseReturnsOfWallsAreMeasured) {
  const Clutter clutter = measured([&](Sight& sight) {
    if (sight.label != walls::kSilent) shorten(sight, 0.5);
  });
  // Half of the returns spread over some 12 m, for each that comes so far: 0.5 / 12 / (1 - 0.5).
  EXPECT_NEAR(clutter.wall_like_per_m, 0.083, 0.03);
  EXPECT_EQ(clutter.others_per_m, 0.0);
  EXPECT_GT(clutter.at_walls, 3.0);
}

TEST_F(ClutterTest, ThingsThatStandThereSayNothingOfWalls) {
  const Clutter clutter = measured([&](Sight& sight) {
    if (random_.uniform() < 0.5) sight = {static_cast<float>(random_.uniform(0.0, 10.0)), 0};
  });
  EXPECT_EQ(clutter.wall_like_per_m, 0.0);
  EXPECT_GT(clutter.others_per_m, 0.03);
  EXPECT_LT(clutter.at_walls, 1.3);
}

}  // namespace
}  // namespace handmap
