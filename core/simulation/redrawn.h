// A map whose outlines are not those of the truth, as no stretching makes them: corners moved,
// annexes and recesses left out.
#pragma once

#include <cstdint>

#include "core/map/map.h"

namespace handmap {

struct Redrawing {
  double corners_m = 0.0;   ///< σ of every corner, in x and in y
  double simplify_m = 0.0;  ///< corners are left out as long as no wall moves by more
};

/// Outlines stay simple and keep at least four corners (or as many as they have); rectangles become
/// polygons where corners move. Fixed buildings stay. Deterministic by seed.
Map redrawn(const Map& truth, const Redrawing& redrawing, std::uint64_t seed);

}  // namespace handmap
