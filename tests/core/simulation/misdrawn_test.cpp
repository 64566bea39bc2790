#include "core/simulation/misdrawn.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/map/map_io.h"
#include "core/simulation/route.h"
#include "core/simulation/world.h"

namespace handmap {
namespace {

TEST(Misdrawn, TheStartIsOffByWhatItSays) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Map truth = twoRowWorld(seed).map;
    const Map drawn =
        misdrawn(truth, truth, {.start_m = 2.0, .start_turn_rad = toRadians(5.0)}, seed);
    const Pose2 off = between(*truth.start, *drawn.start);
    EXPECT_NEAR(off.position().norm(), 2.0, 1e-9);
    EXPECT_NEAR(std::abs(off.heading), toRadians(5.0), 1e-9);
    ASSERT_TRUE(drawn.start_uncertainty);
    EXPECT_EQ(drawn.start_uncertainty->position, 2.0);
    EXPECT_EQ(drawn.start_uncertainty->heading, toRadians(5.0));
    EXPECT_EQ(drawn.buildings, truth.buildings);
  }
}

TEST(Misdrawn, SomeAreNotThereAndAsManyAreLeftOut) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Map truth = campusWorld(seed).map;
    const Map drawn = misdrawn(perturbed(truth, 3.0, seed), truth, {.wrong = 2}, seed);
    EXPECT_EQ(drawn.buildings.size(), truth.buildings.size());
    EXPECT_FALSE(drawn.start_uncertainty);
    int wrong = 0;
    for (const Building& building : drawn.buildings) {
      if (truth.find(building.id)) continue;
      ++wrong;
      const auto meets = [&](const Building& other) {
        return other.id != building.id && overlap(other.footprint(), building.footprint());
      };
      EXPECT_TRUE(std::none_of(truth.buildings.begin(), truth.buildings.end(), meets));
      EXPECT_TRUE(std::none_of(drawn.buildings.begin(), drawn.buildings.end(), meets));
      EXPECT_GE(routeOf(truth)->distanceTo(building.footprint()), 2.0);
      EXPECT_LT(routeOf(truth)->distanceTo(building.footprint()), 20.0);
    }
    EXPECT_EQ(wrong, 2);
    EXPECT_EQ(formatMap(drawn),
              formatMap(misdrawn(perturbed(truth, 3.0, seed), truth, {.wrong = 2}, seed)));
  }
}

TEST(Misdrawn, TellsWhatItCannotDo) {
  const Map rows = twoRowWorld(1).map;
  EXPECT_THROW(misdrawn(rows, rows, {.wrong = 6}, 1), Error);
  Map without_start = rows;
  without_start.start.reset();
  EXPECT_THROW(misdrawn(without_start, rows, {.start_m = 1.0}, 1), Error);
  Map fixed = rows;
  for (Building& building : fixed.buildings) building.fixed = true;
  EXPECT_THROW(misdrawn(fixed, rows, {.wrong = 1}, 1), Error);
}

}  // namespace
}  // namespace handmap
