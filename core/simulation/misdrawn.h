// What else is wrong with drawings than places and sizes: buildings that are not there, buildings
// left out, a start that is not where the robot begins.
#pragma once

#include <cstdint>

#include "core/map/map.h"

namespace handmap {

struct Misdrawing {
  int wrong = 0;                ///< so many drawn that are not there, and as many left out
  double start_m = 0.0;         ///< the start is off by that, in any direction
  double start_turn_rad = 0.0;  ///< and turned by that, either way
};

/// Deterministic by seed. What is not there ("wrong 1" …) stands where neither the truth nor the
/// drawing has a building, beside the route; fixed buildings are not left out. A start that is off
/// says so: handmap:start_uncertainty is what it is off by. Throws BadInput where there are too few
/// buildings, no place for one more, or no start.
Map misdrawn(Map drawing, const Map& truth, const Misdrawing& misdrawing, std::uint64_t seed);

}  // namespace handmap
