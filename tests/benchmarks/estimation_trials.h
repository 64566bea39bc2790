// Trials of the estimator in simulated scenes, and what came of them.
#pragma once

#include <ctime>
#include <vector>

#include "core/base/random.h"
#include "core/estimation/estimator.h"
#include "core/evaluation/comparison.h"
#include "core/perception/range_walls.h"
#include "core/simulation/simulated_source.h"

namespace handmap {

struct TrialConditions {
  double sigma_m = 15.0;
  double undrawn = 0.0;     ///< share of the true buildings that are not drawn
  bool phantom = false;     ///< one drawn building that is not there
  double clutter = 0.0;     ///< share of the returns that come from things in between
  double turned_rad = 0.0;  ///< one σ, of every true building against the drawing
  bool free = false;        ///< the drawing is scaled (0.7 to 1.4) and turned (±30°)
  EstimatorOptions options;
};

struct TrialResult {
  bool loose = true;   ///< every building overlaps its true one
  bool strict = true;  ///< every building has an IoU of at least 0.5
  int doubtful = 0;
  std::vector<BuildingError> as_it_is;
  std::vector<BuildingError> aligned;
  double pose_rms = 0.0;
  double odometry_rms = 0.0;
  std::vector<double> frame_ms;
  double finish_ms = 0.0;
};

/// Processor time: other programs on the machine do not count.
inline double processorMs() { return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Runs the estimator over a source and compares with the truth.
inline TrialResult runTrial(const Map& drawing, const Map& truth, ObservationSource& source,
                            const EstimatorOptions& options, double clutter = 0.0,
                            std::uint64_t seed = 1) {
  TrialResult result;
  HandmapEstimator estimator(drawing, options, seed);
  RangeWalls range_walls(source.info().range_limit_m, {});
  ScanBuilder scans(source.info().range_limit_m);
  std::vector<StampedPose> odometry;
  const Pose2 first = source.info().start_odometry;
  estimator.startFrom(first);
  RandomStream random(seed, 0, 0, 77);
  while (auto observation = source.next()) {
    std::vector<RangePoint> points;
    for (const View& view : observation->views) {
      if (view.points) points.insert(points.end(), view.points->begin(), view.points->end());
    }
    for (RangePoint& p : points) {
      if (random.uniform() >= clutter) continue;
      const auto nearer = static_cast<float>(random.uniform(0.05, 1.0));
      p = {p.x * nearer, p.y * nearer, p.z, p.w};
    }
    const Scan scan = scans(points, range_walls(points, observation->odometry));
    const double begin = processorMs();
    estimator.step(observation->time_s, observation->odometry, scan);
    result.frame_ms.push_back(processorMs() - begin);
    odometry.push_back(
        {observation->time_s, *drawing.start * between(first, observation->odometry)});
  }
  const double begin = processorMs();
  estimator.finish();
  result.finish_ms = processorMs() - begin;
  const Map refined = estimator.refinedMap();
  for (const Building& building : refined.buildings) {
    result.doubtful += static_cast<int>(building.unknown.count("doubtful"));
  }
  result.as_it_is = compareMaps(refined, truth, false).buildings;
  result.aligned = compareMaps(refined, truth, true).buildings;
  for (const BuildingError& error : result.as_it_is) {
    result.loose &= error.overlaps;
    result.strict &= error.iou >= 0.5;
  }
  const Trajectory true_poses(source.info().truth, "truth");
  if (const auto error = compareTrajectories(estimator.trajectory().all(), true_poses)) {
    result.pose_rms = error->rms_m;
  }
  if (const auto error = compareTrajectories(odometry, true_poses)) {
    result.odometry_rms = error->rms_m;
  }
  return result;
}

inline TrialResult twoRowTrial(const TrialConditions& conditions, std::uint64_t seed) {
  World world = twoRowWorld(seed);
  Map drawing = perturbed(world.map, conditions.sigma_m, seed + 1000);
  RandomStream random(seed, 0, 0, 78);
  if (conditions.turned_rad > 0.0) {
    for (Building& building : world.map.buildings) {
      Rectangle box = building.box();
      box.heading += random.normal(0.0, conditions.turned_rad);
      building.shape = box;
    }
  }
  std::vector<Building> kept;
  for (const Building& building : drawing.buildings) {
    if (random.uniform() >= conditions.undrawn) kept.push_back(building);
  }
  if (!kept.empty()) drawing.buildings = kept;
  if (conditions.phantom) {
    Building phantom;
    phantom.id = "phantom";
    phantom.shape = Rectangle{
        {random.uniform(0.0, 200.0), random.uniform() < 0.5 ? 35.0 : -35.0}, 50.0, 15.0, 0.0};
    drawing.buildings.push_back(phantom);
  }
  if (conditions.free) {
    const double scale = random.uniform(0.7, 1.4);
    const double turn = toRadians(random.uniform(-30.0, 30.0));
    const Pose2 motion{0.0, 0.0, turn};
    for (Building& building : drawing.buildings) {
      Rectangle box = building.box();
      building.shape = Rectangle{motion.toOuter(scale * box.centre), scale * box.width,
                                 scale * box.depth, box.heading + turn};
    }
  }
  const auto source = simulate(world, SimulationOptions{}, seed + 2000);
  return runTrial(drawing, world.map, *source, conditions.options, conditions.clutter, seed);
}

}  // namespace handmap
