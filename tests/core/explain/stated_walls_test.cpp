// What a run states of its walls, and why they stand where they do, is one thing.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/explain/wall_story.h"
#include "core/map/certainty.h"
#include "core/session/run_session.h"
#include "core/simulation/simulated_source.h"

namespace handmap {
namespace {

Building shaped(const char* id, std::variant<Rectangle, Polygon> shape) {
  Building building;
  building.id = id;
  building.shape = std::move(shape);
  return building;
}

constexpr TapeLimits kKept{100U << 20U, 0};  // all of it

/// A robot passes north of a kiosk and of an L-shaped block.
TEST(StatedWalls, OfAWallThatIsStatedAsSeenThereAreWitnesses) {
  Map truth;
  truth.start = Pose2{-30.0, 20.0, 0.0};
  truth.route = {{-30.0, 20.0}, {60.0, 20.0}};
  truth.buildings = {
      shaped("kiosk", Rectangle{{0.0, 8.0}, 5.0, 4.0, 0.0}),
      shaped("block", Polygon{{20, -8}, {44, -8}, {44, 10}, {34, 10}, {34, 0}, {20, 0}})};
  const Map sketch = perturbed(truth, 3.0, 1);
  RunSettings settings;
  settings.threads = 1;
  RunSession session(
      sketch,
      std::make_shared<Tape>(simulate(worldFromMap(truth, 1), {}, 1), settings.perception, kKept),
      settings);
  std::vector<std::shared_ptr<const Perceived>> kept;
  std::vector<SeenScan> scans;
  while (const auto snapshot = session.step()) {
    const auto seen = snapshot->seen.lock();
    ASSERT_TRUE(seen);
    if (!kept.empty() && kept.back() == seen) continue;
    kept.push_back(seen);
    scans.push_back({seen->observation.time_s, &seen->percept.scan});
  }
  const Map refined = session.refinedMap();
  int seen_walls = 0;
  int unseen_walls = 0;
  for (std::size_t b = 0; b < refined.buildings.size(); ++b) {
    const Polygon outline = refined.buildings[b].footprint();
    for (std::size_t w = 0; w < outline.size(); ++w) {
      const WallStory story = storyOf(sketch, refined, session.trajectory(), scans, b, w);
      EXPECT_FALSE(story.seen && story.witnesses.empty()) << refined.buildings[b].id << " " << w;
      ++(story.seen ? seen_walls : unseen_walls);
    }
  }
  EXPECT_GE(seen_walls, 4);
  EXPECT_GE(unseen_walls, 2) << "the lower ones";
}

/// One that is seen by a corner only would be another outline with each look.
TEST(StatedWalls, WhatIsShownAsCorrectedOnTheWayHasAWallThatWasSeen) {
  const World world = twoRowWorld(3);
  Map sketch = perturbed(world.map, 5.0, 3);
  sketch.uncertainty = {5.0, 5.0};
  RunSettings settings;
  settings.threads = 1;
  RunSession session(sketch, simulate(world, {}, 3), settings);
  int corrected = 0;
  while (const auto snapshot = session.step()) {
    const bool last = snapshot->report.frame == session.source().observations - 1;
    for (const Building& building : snapshot->map->buildings) {
      const Sides sides = sidesOf(building);
      const bool seen = std::ranges::any_of(sides, &SideEstimate::seen);
      if (!last) {
        EXPECT_EQ(isRecognised(building), seen) << building.id << " at " << snapshot->index;
      }
      corrected += isRecognised(building) ? 1 : 0;
    }
  }
  EXPECT_GT(corrected, 0);
}

}  // namespace
}  // namespace handmap
