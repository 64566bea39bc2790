#include "core/localization/swarm.h"

#include <cmath>

#include <gtest/gtest.h>

namespace handmap {
namespace {

double distanceFrom(const BuildingState& target, const BuildingState& state) {
  return std::hypot(state.x - target.x, state.y - target.y, state.width - target.width);
}

TEST(Swarm, SamplesAroundTheDrawing) {
  RandomStream random(1);
  const Swarm swarm = sampleSwarm({10.0, 20.0, 30.0}, {2.0, 5.0}, 5000, random);
  const BuildingState mean = swarm.mean();
  EXPECT_NEAR(mean.x, 10.0, 0.15);
  EXPECT_NEAR(mean.y, 20.0, 0.15);
  EXPECT_NEAR(mean.width, 30.0, 0.3);
  double squares = 0.0;
  for (const SwarmMember& member : swarm.members)
    squares += std::pow(member.position.width - 30, 2);
  EXPECT_NEAR(std::sqrt(squares / 5000.0), 5.0, 0.2);
}

TEST(Swarm, WidthsStayPositive) {
  RandomStream random(2);
  for (const SwarmMember& member : sampleSwarm({0, 0, 2.0}, {1.0, 50.0}, 500, random).members) {
    EXPECT_GE(member.position.width, kMinWidth);
  }
}

TEST(Swarm, FindsASmoothMaximumOverAFewFrames) {
  const BuildingState target{12.0, 19.0, 27.0};
  const auto score = [&](const BuildingState& state) {
    return std::exp(-0.05 * distanceFrom(target, state));
  };
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    RandomStream random(seed);
    Swarm swarm = sampleSwarm({10.0, 20.0, 30.0}, {2.0, 3.0}, 20, random);
    for (int frame = 0; frame < 5; ++frame) swarm = refined(swarm, score, {}, random);
    EXPECT_LT(distanceFrom(target, swarm.best), 0.5) << seed;
    EXPECT_EQ(swarm.observations, 5);
  }
}

TEST(Swarm, WhereNothingIsHitTheDrawingStays) {
  RandomStream random(3);
  Swarm swarm = sampleSwarm({10.0, 20.0, 30.0}, {2.0, 3.0}, 20, random);
  const double first = swarm.members[0].position.x;
  swarm = refined(
      std::move(swarm), [](const BuildingState&) { return 0.0; }, {}, random);
  EXPECT_EQ(swarm.best.x, 10.0);
  EXPECT_EQ(swarm.members[0].position.x, first);
  EXPECT_EQ(swarm.observations, 0);
}

}  // namespace
}  // namespace handmap
