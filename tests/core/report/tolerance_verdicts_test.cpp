// Whether walls are where the class says that they surely are.
#include <gtest/gtest.h>

#include "core/report/report.h"
#include "core/session/run_session.h"
#include "core/simulation/simulated_source.h"
#include "core/simulation/world.h"

namespace handmap {
namespace {

constexpr double kSure = 0.95;

/// Of the smallest class in which a wall surely is; nullopt: it is in none.
std::optional<double> classOf(const WallTolerance& wall) {
  for (std::size_t i = 0; i < kTolerances_m.size(); ++i) {
    if (wall.within[i] >= kSure) return kTolerances_m[i];
  }
  return std::nullopt;
}

struct Verdicts {
  int seen = 0;
  int said = 0;
  int right = 0;
};

Verdicts verdictsOn(const World& world, double sigma_m, std::uint64_t seed) {
  Map drawing = perturbed(world.map, sigma_m, seed);
  drawing.uncertainty = {sigma_m, sigma_m};
  RunSettings settings;
  settings.seed = seed;
  RunSession session(drawing, simulate(world, {}, seed), settings);
  while (session.step()) {
  }
  const Map refined = session.refinedMap();
  Verdicts verdicts;
  for (const WallTolerance& wall : tolerancesOf(drawing, refined)) {
    if (!wall.seen) continue;
    const double off =
        wallOffset(*refined.find(wall.building), *world.map.find(wall.building), wall.side);
    ++verdicts.seen;
    const auto within = classOf(wall);
    if (!within) continue;
    ++verdicts.said;
    verdicts.right += off <= *within ? 1 : 0;
  }
  return verdicts;
}

TEST(Tolerances, AreRightInNineteenOfTwentyWalls) {
  Verdicts all;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Verdicts some = verdictsOn(twoRowWorld(seed), seed % 2 == 0 ? 3.0 : 5.0, seed);
    all.seen += some.seen;
    all.said += some.said;
    all.right += some.right;
  }
  EXPECT_GT(all.said, 200);
  EXPECT_GT(all.said, 0.8 * all.seen) << "most of what was seen has a class";
  EXPECT_GE(all.right, 0.95 * all.said) << all.right << " of " << all.said;
  RecordProperty("right", all.right);
  RecordProperty("said", all.said);
}

/// Where hedges and parked cars stand before the fronts.
TEST(Tolerances, OfAFurnishedStreetAreMostlyRight) {
  Verdicts all;
  for (std::uint64_t seed = 2; seed <= 9; ++seed) {
    const Verdicts some = verdictsOn(streetWorld(seed), 5.0, seed);
    all.said += some.said;
    all.right += some.right;
  }
  EXPECT_GT(all.said, 120);
  EXPECT_GE(all.right, 0.85 * all.said) << all.right << " of " << all.said;
}

}  // namespace
}  // namespace handmap
