// Particle swarm optimization of one building (paper, III; Kennedy & Eberhart 1995).
#pragma once

#include <functional>
#include <vector>

#include "core/base/random.h"
#include "core/localization/building_model.h"
#include "core/localization/slam_options.h"
#include "core/map/map.h"

namespace handmap {

/// Buildings are never narrower than this, metres.
inline constexpr double kMinWidth = 1.0;

struct SwarmMember {
  BuildingState position;
  BuildingState velocity;
};

/// One building of one map: hypotheses about it, and the best of them.
struct Swarm {
  std::vector<SwarmMember> members;
  BuildingState best;
  double best_score = 0.0;  ///< of the last refinement; 0: never refined or never hit
  int observations = 0;     ///< refinements that hit a wall

  BuildingState mean() const;  ///< of the members; the best where there are none
};

/// Members drawn from a Gaussian around the drawing; the drawing is the best until one is scored.
Swarm sampleSwarm(const BuildingState& drawn, const Uncertainty& uncertainty, int members,
                  RandomStream& random);

using BuildingScore = std::function<double(const BuildingState&)>;

/// v ← w v + c₁ r₁ (p − x) + c₂ r₂ (g − x), x ← x + v, at most `pso_iterations` times or until the
/// members have met. Scores of earlier observations are forgotten: p and g start anew.
Swarm refined(Swarm swarm, const BuildingScore& score, const SlamOptions& options,
              RandomStream& random);

}  // namespace handmap
