#include "core/method/handmap_phases.h"

#include <algorithm>

#include "core/method/constants.h"

namespace handmap {

using namespace method;

namespace {

PhaseKind kindOf(EstimatorPhase phase) {
  switch (phase) {
    case EstimatorPhase::Way:
      return PhaseKind::Way;
    case EstimatorPhase::Poses:
      return PhaseKind::Poses;
    case EstimatorPhase::Evidence:
      return PhaseKind::Evidence;
    case EstimatorPhase::Detection:
      return PhaseKind::Detection;
    case EstimatorPhase::Labels:
      return PhaseKind::Labels;
    case EstimatorPhase::Correction:
      break;
  }
  return PhaseKind::Correction;
}

}  // namespace

HandmapPhases::HandmapPhases(const HandmapEstimator& estimator, const Map& drawing,
                             PhaseRecorder& recorder, const EstimationMethod& method)
    : estimator_(estimator),
      drawing_(drawing),
      recorder_(recorder),
      method_(method),
      before_(recorder.now().report.pose),
      loops_(recorder.now().report.loops) {}

void HandmapPhases::operator()(EstimatorPhase step) {
  const PhaseKind kind = kindOf(step);
  Snapshot& now = recorder_.now();
  method_.describe(now.report);
  now.particles = method_.particles();
  now.trajectory = method_.trajectory();
  if (kind == PhaseKind::Evidence) {
    const LocalMap evidence = estimator_.evidence();
    now.local_map = LazyLocalMap(evidence.range(), [map = evidence] { return map; });
  }
  Lazy<Map> map_before = now.map;
  if (kind == PhaseKind::Correction) now.map = Lazy<Map>(method_.refinedMap());
  Phase& phase = recorder_.add(kind);
  const Pose2 moved = between(before_, now.report.pose);
  phase.facts.moved_m = moved.position().norm();
  phase.facts.turned = moved.heading;
  before_ = now.report.pose;
  if (kind == PhaseKind::Detection) tellWalls(phase);
  if (kind == PhaseKind::Labels) tellLabels(phase);
  if (kind == PhaseKind::Correction && map_before) tellCorrection(phase, *map_before);
}

void HandmapPhases::tellWalls(Phase& phase) const {
  for (const FoundWall& wall : estimator_.walls()) phase.walls.push_back({wall.a, wall.b});
  for (const FoundBox& found : estimator_.found()) {
    if (found.in_sight) phase.outlines.push_back(found.box.polygon());
  }
  phase.facts.count = static_cast<int>(phase.outlines.size());
  phase.facts.of = static_cast<int>(phase.walls.size());
}

void HandmapPhases::tellLabels(Phase& phase) const {
  for (const FoundBox& found : estimator_.found()) {
    if (!found.in_sight) continue;
    phase.outlines.push_back(found.box.polygon());
    const auto drawn = estimator_.drawnOf(found.id);
    if (!drawn) continue;
    phase.links.push_back({found.box.rectangle().centre, drawing_.buildings[*drawn].box().centre});
  }
  phase.facts.count = static_cast<int>(phase.links.size());
  phase.facts.of = static_cast<int>(phase.outlines.size());
}

void HandmapPhases::tellCorrection(Phase& phase, const Map& before) const {
  const Map& after = *phase.shown.map;
  phase.facts.moved_m = 0.0;
  for (std::size_t b = 0; b < std::min(before.buildings.size(), after.buildings.size()); ++b) {
    const double moved =
        (after.buildings[b].box().centre - before.buildings[b].box().centre).norm();
    if (moved > kLeast_m) ++phase.facts.count;
    phase.facts.moved_m = std::max(phase.facts.moved_m, moved);
  }
  phase.facts.happened = phase.shown.report.loops > loops_;
}

}  // namespace handmap
