// What a visual front end sees of a world that follows few corners: triangulated points with the
// number of the track each is a look of.
#pragma once

#include <memory>

#include "core/simulation/simulated_source.h"

namespace handmap {

struct FeatureOptions {
  double tracks = 50.0;  ///< in a frame, on average
  /// > 0: a frame holds what was seen in so many metres before it, joined by the odometry.
  double joined_m = 0.0;
};

/// Of `options` the way, the odometry and the range limit count. Looks ahead; a third of the tracks
/// is on walls where there are any in view, the others on cars, hedges, trees and ground. All
/// weights are 1. The page of the room has the figures. Deterministic by seed.
std::unique_ptr<ObservationSource> simulateFeatures(const World& world,
                                                    const SimulationOptions& options,
                                                    const FeatureOptions& features,
                                                    std::uint64_t seed);

/// A car on the move with that.
SimulationOptions drivingPastFeatures(double step_m);

}  // namespace handmap
