// The way of a simulated robot through a map, as it is and as its odometry tells it.
#pragma once

#include <cstdint>

#include "core/map/map.h"
#include "core/recording/observation.h"
#include "core/simulation/simulated_source.h"

namespace handmap {

struct Drive {
  std::vector<StampedPose> truth;     ///< map frame, one pose every step of the route
  std::vector<StampedPose> odometry;  ///< at the same times, the identity at first
};

/// Deterministic by seed, whatever the sensor. Throws BadInput where the map has no way to drive.
Drive driveThrough(const Map& map, const SimulationOptions& options, std::uint64_t seed);

/// What a source tells of itself but for its sensor.
SourceInfo infoOf(const World& world, const SimulationOptions& options, std::uint64_t seed);

/// What it reports at a pose of the drive, but for what its sensor sees there.
Observation observationAt(std::size_t pose, const SourceInfo& info);

}  // namespace handmap
