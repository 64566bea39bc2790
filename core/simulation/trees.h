// Round things beside a route that no one draws.
#pragma once

#include "core/base/random.h"
#include "core/simulation/route.h"
#include "core/simulation/world.h"

namespace handmap {

/// Some trees on each side, clear of the buildings and of the robot's way.
std::vector<Obstacle> treesAlong(const Route& route, const Map& map, RandomStream& random);

}  // namespace handmap
