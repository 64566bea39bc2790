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

TEST(Tolerances, AreRightInNineteenOfTwentyWalls) {
  int walls = 0;
  int seen = 0;
  int right = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const World world = twoRowWorld(seed);
    const double sigma_m = seed % 2 == 0 ? 3.0 : 5.0;
    Map drawing = perturbed(world.map, sigma_m, seed);
    drawing.uncertainty = {sigma_m, sigma_m};
    RunSettings settings;
    settings.seed = seed;
    RunSession session(drawing, simulate(world, {}, seed), settings);
    while (session.step()) {
    }
    const Map refined = session.refinedMap();
    for (const WallTolerance& wall : tolerancesOf(drawing, refined)) {
      seen += wall.seen ? 1 : 0;
      const auto within = classOf(wall);
      if (!wall.seen || !within) continue;
      ++walls;
      const double off =
          wallOffset(*refined.find(wall.building), *world.map.find(wall.building), wall.side);
      right += off <= *within ? 1 : 0;
    }
  }
  EXPECT_GT(walls, 200);
  EXPECT_GT(walls, 0.8 * seen) << "most of what was seen has a class";
  EXPECT_GE(right, 0.95 * walls) << right << " of " << walls;
  RecordProperty("right", right);
  RecordProperty("walls", walls);
}

}  // namespace
}  // namespace handmap
