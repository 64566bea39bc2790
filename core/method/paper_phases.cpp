#include "core/method/paper_phases.h"

#include <algorithm>
#include <cmath>

#include "core/fastslam/resampling.h"

namespace handmap {

namespace {

std::vector<ParticleView> viewsOf(const std::vector<SlamTrace::WeighedPose>& poses) {
  std::vector<ParticleView> views;
  views.reserve(poses.size());
  for (const auto& [pose, weight] : poses) views.push_back({pose, weight});
  return views;
}

/// One that had met before the others stands still.
const SlamTrace::Iteration& at(const SlamTrace::Building& building, std::size_t iteration) {
  return building.iterations[std::min(iteration, building.iterations.size() - 1)];
}

std::size_t iterationsOf(const SlamTrace& trace) {
  std::size_t most = 0;
  for (const SlamTrace::Building& building : trace.buildings) {
    most = std::max(most, building.iterations.size());
  }
  return most;
}

void tellSwarms(const SlamTrace& trace, const Map& drawing, std::size_t iteration,
                PhaseRecorder& recorder) {
  Snapshot& now = recorder.now();
  PhaseFacts facts;
  std::vector<Polygon> bests;
  now.swarms.clear();
  for (const SlamTrace::Building& building : trace.buildings) {
    if (building.iterations.empty()) continue;
    const SlamTrace::Iteration& shown = at(building, iteration);
    const Building& drawn = drawing.buildings[building.building];
    SwarmView view{building.building, {}};
    for (const Rectangle& box : shown.members)
      view.members.push_back(drawn.fitted(box).footprint());
    now.swarms.push_back(std::move(view));
    bests.push_back(drawn.fitted(shown.best).footprint());
    facts.value += shown.best_score;
    if (iteration == 0) continue;
    const Vec2 moved = shown.best.centre - at(building, iteration - 1).best.centre;
    facts.moved_m = std::max(facts.moved_m, moved.norm());
  }
  facts.iteration = static_cast<int>(iteration);
  facts.iterations = static_cast<int>(iterationsOf(trace)) - 1;
  facts.count = static_cast<int>(bests.size());
  Phase& phase = recorder.add(PhaseKind::Swarms);
  phase.facts = facts;
  phase.outlines = std::move(bests);
}

}  // namespace

void tellPhases(const SlamTrace& trace, const PaperStep& step, PhaseRecorder& recorder) {
  Snapshot& now = recorder.now();
  const Pose2 predicted = trace.predicted[trace.watched].pose;
  now.particles = viewsOf(trace.predicted);
  now.report.pose = predicted;
  now.swarms.clear();
  const Pose2 moved = between(step.before, predicted);
  PhaseFacts& driven = recorder.add(PhaseKind::Prediction).facts;
  driven.moved_m = moved.position().norm();
  driven.turned = moved.heading;
  now.local_map = step.local_map;
  recorder.add(PhaseKind::LocalMap);
  for (std::size_t i = 0; i < iterationsOf(trace); ++i) {
    tellSwarms(trace, step.drawing, i, recorder);
  }
  std::vector<double> weights;
  for (const auto& weighed : trace.weighed) weights.push_back(weighed.weight);
  const auto heaviest = std::max_element(weights.begin(), weights.end()) - weights.begin();
  now.particles = viewsOf(trace.weighed);
  now.report.pose = trace.weighed[static_cast<std::size_t>(heaviest)].pose;
  PhaseFacts& weighed = recorder.add(PhaseKind::Weights).facts;
  weighed.value = effectiveSampleSize(weights);
  weighed.of = static_cast<int>(weights.size());
  now.particles.clear();
  for (const Particle& particle : step.slam.particles()) {
    now.particles.push_back({particle.pose, particle.weight});
  }
  now.report.pose = step.slam.best().pose;
  now.map = Lazy<Map>([map = step.slam.refinedMap()] { return map; });
  PhaseFacts& resampled = recorder.add(PhaseKind::Resampling).facts;
  resampled.happened = trace.resampled;
  resampled.count = static_cast<int>(trace.resampled ? trace.survivors : weights.size());
  resampled.of = static_cast<int>(weights.size());
}

}  // namespace handmap
