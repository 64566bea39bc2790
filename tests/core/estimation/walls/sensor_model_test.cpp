#include "core/estimation/walls/sensor_model.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace handmap {
namespace {

constexpr int kWall = walls::kLabels - 1;

double plainRatio(const MeasuredSensor& o, double range, double distance, double slack) {
  const double sigma = std::hypot(o.noise.at(distance), slack);
  const double z = (range - distance) / sigma;
  const double density = std::exp(-0.5 * z * z) / (sigma * std::sqrt(2.0 * std::numbers::pi));
  const double behind = 0.5 * std::erfc(-z / std::numbers::sqrt2);
  return walls::kTemper * std::log(1.0 - walls::kHit * behind +
                                   walls::kHit * walls::kRecognised * density / walls::kWallLike);
}

TEST(SensorModel, IsTheTabulatedFormula) {
  const MeasuredSensor measured;
  const SensorModel model(measured, 40.0);
  for (double distance = 2.0; distance < 38.0; distance += 1.7) {
    for (double off = -2.0; off <= 2.0; off += 0.25) {
      const double sigma = std::hypot(measured.noise.at(distance), 0.1);
      const float range = static_cast<float>(distance + off * sigma);
      EXPECT_NEAR(model({range, kWall}, static_cast<float>(distance), 0.1F),
                  plainRatio(measured, range, distance, 0.1), 0.15)
          << distance << " " << off;
    }
  }
}

TEST(SensorModel, ThingsInFrontSayNothing) {
  const SensorModel model(MeasuredSensor{}, 40.0);
  EXPECT_EQ(model({5.0F, kWall}, 20.0F, 0.1F), 0.0F);
}

TEST(SensorModel, ReturnsFromBehindAndSilenceSpeakAgainst) {
  const SensorModel model(MeasuredSensor{}, 40.0);
  EXPECT_FLOAT_EQ(model({30.0F, kWall}, 10.0F, 0.1F), model.passed());
  EXPECT_LT(model.passed(), 0.0F);
  EXPECT_FLOAT_EQ(model({36.0F, walls::kSilent}, 10.0F, 0.1F), model.silent());
  EXPECT_EQ(model({36.0F, walls::kSilent}, 37.0F, 0.1F), 0.0F);
}

TEST(SensorModel, ResponsibilityFallsWithTheError) {
  const SensorModel model(MeasuredSensor{}, 40.0);
  EXPECT_GT(model.responsibility(kWall, 0.0, 0.2), 0.9);
  EXPECT_LT(model.responsibility(kWall, 1.2, 0.2), 0.01);
}

/// A robust mean of returns from a wall and from things in front of it is off by what it says.
TEST(SensorModel, KnowsWhatClutterPulls) {
  MeasuredSensor measured;
  EXPECT_NEAR(SensorModel(measured, 40.0).clutterError(kWall, 0.5), 0.0, 1e-6);
  measured.clutter.wall_like_per_m = 0.1;
  const SensorModel model(measured, 40.0);
  constexpr double kSigma = 0.5;
  RandomStream random(1, 0, 0, 0);
  double weights = 0.0;
  double errors = 0.0;
  const auto add = [&](double error) {
    if (std::abs(error) > 4.0 * kSigma) return;
    const double weight = model.responsibility(kWall, error, kSigma);
    weights += weight;
    errors += weight * error;
  };
  for (int i = 0; i < 200000; ++i) {
    // For each ray that reaches the wall and comes back recognised, what stopped in front of it.
    if (random.uniform() < walls::kHit * walls::kRecognised) add(random.normal(0.0, kSigma));
    const double before = random.uniform(-2.0, 2.0);
    const bool passes = random.uniform() < walls::kHit && before + random.normal(0.0, kSigma) > 0.0;
    if (random.uniform() < 4.0 * measured.clutter.wall_like_per_m && !passes) add(before);
  }
  EXPECT_NEAR(model.clutterError(kWall, kSigma), errors / weights, 0.02);
  EXPECT_LT(model.clutterError(kWall, kSigma), -0.05);
}

}  // namespace
}  // namespace handmap
