#include "core/fastslam/swarm.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace handmap {
namespace {

double distanceFrom(const Swarm::Values& target, const Swarm::Values& state) {
  return static_cast<double>(
      std::hypot(state[0] - target[0], state[1] - target[1], state[2] - target[2]));
}

TEST(Swarm, SamplesAroundTheDrawing) {
  RandomStream random(1);
  const Swarm swarm = sampleSwarm(30.0, {2.0, 5.0}, 5000, random);
  EXPECT_NEAR(swarm.mean[Swarm::X], 0.0, 0.15);
  EXPECT_NEAR(swarm.mean[Swarm::Y], 0.0, 0.15);
  EXPECT_NEAR(swarm.mean[Swarm::Width], 30.0, 0.3);
  EXPECT_NEAR(std::sqrt(swarm.variance[Swarm::X]), 2.0, 0.1);
  EXPECT_NEAR(std::sqrt(swarm.variance[Swarm::Width]), 5.0, 0.2);
}

TEST(Swarm, WidthsStayPositive) {
  RandomStream random(2);
  const Swarm swarm = sampleSwarm(2.0, {1.0, 50.0}, 500, random);
  for (const float width : swarm.positions(Swarm::Width)) EXPECT_GE(width, kMinWidth);
}

TEST(Swarm, FindsASmoothMaximumOverAFewFrames) {
  const Swarm::Values target{2.0F, -1.0F, 27.0F};
  const auto score = [&](const Swarm& swarm, std::span<float> scores) {
    for (std::size_t i = 0; i < scores.size(); ++i) {
      scores[i] = static_cast<float>(std::exp(-0.05 * distanceFrom(target, swarm.member(i))));
    }
  };
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    RandomStream random(seed);
    Swarm swarm = sampleSwarm(30.0, {2.0, 3.0}, 20, random);
    for (int frame = 0; frame < 5; ++frame) refine(swarm, score, {}, random);
    EXPECT_LT(distanceFrom(target, swarm.best), 0.5) << seed;
    EXPECT_EQ(swarm.observations, 5);
  }
}

TEST(Swarm, KnowsItsMomentsAfterItMoved) {
  const auto score = [](const Swarm& swarm, std::span<float> scores) {
    for (std::size_t i = 0; i < scores.size(); ++i) {
      scores[i] = std::exp(-std::abs(swarm.positions(Swarm::X)[i]));
    }
  };
  RandomStream random(4);
  Swarm swarm = sampleSwarm(30.0, {2.0, 3.0}, 20, random);
  refine(swarm, score, {}, random);
  double sum = 0.0;
  double squares = 0.0;
  for (const float x : swarm.positions(Swarm::X)) {
    sum += static_cast<double>(x) / 20.0;
    squares += static_cast<double>(x) * static_cast<double>(x) / 20.0;
  }
  EXPECT_NEAR(swarm.mean[Swarm::X], sum, 1e-5);
  EXPECT_NEAR(swarm.variance[Swarm::X], squares - sum * sum, 1e-5);
}

TEST(Swarm, WhereNothingIsHitTheDrawingStays) {
  RandomStream random(3);
  Swarm swarm = sampleSwarm(30.0, {2.0, 3.0}, 20, random);
  const Swarm::Values first = swarm.member(0);
  refine(
      swarm, [](const Swarm&, std::span<float> scores) { std::ranges::fill(scores, 0.0F); }, {},
      random);
  EXPECT_EQ(swarm.best, (Swarm::Values{0.0F, 0.0F, 30.0F}));
  EXPECT_EQ(swarm.member(0), first);
  EXPECT_EQ(swarm.observations, 0);
}

TEST(Swarm, AStopEndsARefinement) {
  RandomStream random(5);
  Swarm swarm = sampleSwarm(30.0, {2.0, 3.0}, 20, random);
  std::stop_source stop;
  int calls = 0;
  SlamOptions options;
  options.pso_iterations = 10000;
  const auto restless = [&](const Swarm&, std::span<float> scores) {
    std::ranges::fill(scores, 1.0F);
    if (++calls == 3) stop.request_stop();
  };
  refine(swarm, restless, options, random, stop.get_token());
  EXPECT_EQ(calls, 3);
}

}  // namespace
}  // namespace handmap
