#include "core/estimation/sensor_model.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace handmap {
namespace {

constexpr int kWall = SensorModel::kLabels - 1;

double plainRatio(const SensorOptions& o, double range, double distance, double slack) {
  const double sigma = std::hypot(o.noise.at(distance), slack);
  const double z = (range - distance) / sigma;
  const double density = std::exp(-0.5 * z * z) / (sigma * std::sqrt(2.0 * std::numbers::pi));
  const double behind = 0.5 * std::erfc(-z / std::numbers::sqrt2);
  return o.temper *
         std::log(1.0 - o.hit * behind + o.hit * o.recognised * density / o.wall_like_per_m);
}

TEST(SensorModel, IsTheTabulatedFormula) {
  const SensorOptions options;
  const SensorModel model(options, 40.0);
  for (double distance = 2.0; distance < 38.0; distance += 1.7) {
    for (double off = -2.0; off <= 2.0; off += 0.25) {
      const double sigma = std::hypot(options.noise.at(distance), 0.1);
      const float range = static_cast<float>(distance + off * sigma);
      EXPECT_NEAR(model({range, kWall}, static_cast<float>(distance), 0.1F),
                  plainRatio(options, range, distance, 0.1), 0.15)
          << distance << " " << off;
    }
  }
}

TEST(SensorModel, ThingsInFrontSayNothing) {
  const SensorModel model(SensorOptions{}, 40.0);
  EXPECT_EQ(model({5.0F, kWall}, 20.0F, 0.1F), 0.0F);
}

TEST(SensorModel, ReturnsFromBehindAndSilenceSpeakAgainst) {
  const SensorModel model(SensorOptions{}, 40.0);
  EXPECT_FLOAT_EQ(model({30.0F, kWall}, 10.0F, 0.1F), model.passed());
  EXPECT_LT(model.passed(), 0.0F);
  EXPECT_FLOAT_EQ(model({36.0F, SensorModel::kSilent}, 10.0F, 0.1F), model.silent());
  EXPECT_EQ(model({36.0F, SensorModel::kSilent}, 37.0F, 0.1F), 0.0F);
}

TEST(SensorModel, ResponsibilityFallsWithTheError) {
  const SensorModel model(SensorOptions{}, 40.0);
  EXPECT_GT(model.responsibility(kWall, 0.0, 0.2), 0.9);
  EXPECT_LT(model.responsibility(kWall, 1.2, 0.2), 0.01);
}

}  // namespace
}  // namespace handmap
