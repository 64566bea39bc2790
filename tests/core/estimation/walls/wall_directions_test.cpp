#include "core/estimation/walls/wall_directions.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "tests/core/estimation/scene.h"

namespace handmap {
namespace {

TEST(WallDirections, AreThoseOfTheBuildingsSeen) {
  RandomStream random(3);
  const SensorModel sensor(MeasuredSensor{}, 40.0);
  const std::vector<Box> boxes{boxOf({{-15.0, 15.0}, 20.0, 8.0, toRadians(20.0)}),
                               boxOf({{15.0, 15.0}, 24.0, 8.0, toRadians(55.0)})};
  WallDirections directions;
  EXPECT_TRUE(directions.peaks().empty());
  for (double x = -20.0; x <= 20.0; x += 2.0) {
    const Frame frame = seenFrom({x, -5.0, toRadians(2.0 * x)}, boxes, 0.1, random);
    directions.add(frame, frame.pose, sensor);
  }
  const std::vector<double> peaks = directions.peaks();
  ASSERT_EQ(peaks.size(), 2u);
  for (const double heading : {toRadians(20.0), toRadians(55.0)}) {
    const double error = std::min(std::abs(directionError(peaks[0], heading)),
                                  std::abs(directionError(peaks[1], heading)));
    EXPECT_LT(error, toRadians(2.0));
  }
}

TEST(WallDirections, NoneInACloudOfReturns) {
  RandomStream random(4);
  const SensorModel sensor(MeasuredSensor{}, 40.0);
  WallDirections directions;
  for (int k = 0; k < 30; ++k) {
    Scan scan;
    for (int i = 0; i < 720; ++i) {
      const auto bearing = static_cast<float>(-kPi + (i + 0.5) * kPi / 360.0);
      const auto range = static_cast<float>(random.uniform(5.0, 30.0));
      scan.rays.push_back({bearing, range, 0.1F, 1.0F, true});
    }
    const Frame frame = makeFrame(0.0, {}, {}, scan);
    directions.add(frame, frame.pose, sensor);
  }
  EXPECT_TRUE(directions.peaks().empty());
}

}  // namespace
}  // namespace handmap
