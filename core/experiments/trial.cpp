#include "core/experiments/trial.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/evaluation/comparison.h"
#include "core/simulation/drawn_by_people.h"
#include "core/simulation/simulated_source.h"

namespace handmap {

namespace {

std::array<double, 3> measuresOf(const BuildingError& error) {
  return {error.x, error.front, error.width};
}

double meanError(const Map& map, const Map& truth) {
  const MeanErrors mean = compareMaps(map, truth, false).mean();
  return (mean.x + mean.front + mean.width) / 3.0;
}

TrialStep stepOf(const Snapshot& snapshot, const Map& truth) {
  if (!snapshot.truth) throw Error(ErrorCode::RunFailed, "trial: an observation without truth");
  const Vec2 place = snapshot.truth->position();
  return {(snapshot.report.pose.position() - place).norm(),
          (snapshot.odometry.back().pose.position() - place).norm(),
          meanError(*snapshot.map, truth)};
}

void compare(const Map& drawing, const Map& refined, const Map& truth, Trial& trial) {
  const MapComparison drawn = compareMaps(drawing, truth, false);
  const MapComparison found = compareMaps(refined, truth, false);
  if (drawn.buildings.size() != trial.buildings.size() ||
      found.buildings.size() != trial.buildings.size()) {
    throw Error(ErrorCode::RunFailed, "trial: buildings are missing from the corrected map");
  }
  for (std::size_t i = 0; i < trial.buildings.size(); ++i) {
    const BuildingError& error = found.buildings[i];
    trial.buildings[i] = {measuresOf(drawn.buildings[i]), measuresOf(error), error.iou,
                          error.overlaps};
  }
}

Map drawingOf(const Map& truth, double sigma_m, std::uint64_t seed, const TrialSettings& settings) {
  if (settings.like == Like::Sigma) return perturbed(truth, sigma_m, seed, settings.keeping);
  PeopleErrors errors;
  errors.position = sigma_m / extentOf(truth);
  errors.missing = 0.0;
  return drawnByPeople(truth, errors, seed, settings.keeping);
}

}  // namespace

double Trial::stepLength() { return SimulationOptions{}.step_m; }

bool Trial::loose() const {
  return std::all_of(buildings.begin(), buildings.end(),
                     [](const TrialBuilding& building) { return building.overlaps; });
}

bool Trial::strict() const {
  return std::all_of(buildings.begin(), buildings.end(),
                     [](const TrialBuilding& building) { return building.iou >= kStrictIou; });
}

TrialScene sceneOf(const TrialKey& key, const TrialSettings& settings) {
  const std::uint64_t seed = settings.seed + static_cast<std::uint64_t>(key.number);
  TrialScene scene{twoRowWorld(seed), {}, {}};
  scene.drawing = drawingOf(scene.world.map, key.sigma_m, seed, settings);
  scene.run.method = key.method;
  scene.run.slam.slam_particles = settings.slam_particles;
  scene.run.slam.pso_particles = settings.pso_particles;
  scene.run.seed = seed;
  scene.run.threads = 1;
  return scene;
}

std::optional<Trial> runTrial(const TrialKey& key, const TrialSettings& settings,
                              const std::stop_token& stop) {
  const auto [world, drawing, run] = sceneOf(key, settings);
  RunSession session(drawing, simulate(world, {}, run.seed), run);
  Trial trial;
  trial.key = key;
  while (const auto snapshot = session.step(stop)) {
    // What the end of the run has changed was not known on the way.
    if (session.frames().size() > trial.way.size()) {
      trial.way.push_back(stepOf(*snapshot, world.map));
    }
  }
  if (stop.stop_requested()) return std::nullopt;
  compare(drawing, session.refinedMap(), world.map, trial);
  return trial;
}

}  // namespace handmap
