#include "core/experiments/reliability.h"

#include <cmath>

#include "core/base/error.h"
#include "core/method/pose_trust.h"
#include "core/simulation/simulated_source.h"

namespace handmap {

namespace {

/// How far the four sides of a box lie from those of the true building.
std::array<double, 4> sidesOff(const Building& found, const Building& truth) {
  const Rectangle box = found.box();
  const Rectangle of_truth = boundingRectangle(truth.footprint(), box.heading);
  std::array<double, 4> off{};
  for (std::size_t side = 0; side < off.size(); ++side) {
    const Vec2 normal = unitVector(box.heading + static_cast<double>(side) * kPi / 2.0);
    const double half =
        0.5 * (side % 2 == 0 ? of_truth.width - box.width : of_truth.depth - box.depth);
    off[side] = std::abs(normal.dot(of_truth.centre - box.centre) + half);
  }
  return off;
}

void addWalls(const Snapshot& last, const Map& truth, RunStatements& statements) {
  for (const BuildingTrust& trust : trustOf(*last.map)) {
    const Building& found = last.map->buildings[trust.building];
    const Building* true_one = truth.find(found.id);
    if (true_one == nullptr) continue;
    const std::array<double, 4> off = sidesOff(found, *true_one);
    for (std::size_t side = 0; side < off.size(); ++side) {
      statements.walls.push_back({trust.within, off[side] <= trust.sigma_m[side]});
    }
  }
}

}  // namespace

std::optional<RunStatements> observeRun(const std::string& name, RunSession& session,
                                        const Map* truth, const std::stop_token& stop) {
  if (session.source().truth.empty()) {
    throwBadInput(name, "truth.tum", "no poses", "the true ones of the recording");
  }
  RunStatements statements;
  statements.name = name;
  std::shared_ptr<const Snapshot> last;
  std::size_t done = 0;
  std::optional<Vec2> before;
  while (const auto snapshot = session.step(stop)) {
    last = snapshot;
    // What the end of the run has changed was not stated on the way.
    const bool live = session.frames().size() > done;
    done = session.frames().size();
    if (!live || !snapshot->truth) continue;
    const Vec2 place = snapshot->truth->position();
    if (before && (place - *before).norm() < kStatementStep_m) continue;
    before = place;
    const double off = (snapshot->report.pose.position() - place).norm();
    for (std::size_t i = 0; i < method::kWithin_m.size(); ++i) {
      statements.pose[i].push_back({snapshot->report.within[i], off <= method::kWithin_m[i]});
    }
  }
  if (stop.stop_requested()) return std::nullopt;
  if (truth && last) addWalls(*last, *truth, statements);
  return statements;
}

std::optional<RunStatements> observeTrial(const TrialKey& key, const TrialSettings& settings,
                                          const std::stop_token& stop) {
  const TrialScene scene = sceneOf(key, settings);
  RunSession session(scene.drawing, simulate(scene.world, {}, scene.run.seed), scene.run);
  auto statements = observeRun("simulated", session, &scene.world.map, stop);
  if (statements) statements->simulated = true;
  return statements;
}

}  // namespace handmap
