// Where the walls of a refined building may be.
#pragma once

#include <vector>

#include "core/map/map.h"

namespace handmap {

/// One standard deviation to both sides of each wall that was seen; of other walls nothing.
std::vector<Polygon> wallBands(const Building& building);

/// The footprint with each wall moved outwards by its offset (inwards when negative); corners stay
/// corners. Empty when the walls would pass through each other.
Polygon offsetWalls(const Polygon& footprint, const std::vector<double>& offsets_m);

}  // namespace handmap
