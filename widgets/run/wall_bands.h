// Where the walls of a refined building may be.
#pragma once

#include <vector>

#include "core/map/map.h"

namespace handmap {

/// One standard deviation of each wall of the footprint (from corner i to i + 1) along its normal,
/// metres: of the centre, and of half the width for walls that end it.
std::vector<double> wallSigmas(const Building& building);

/// The footprint with each wall moved outwards by its offset (inwards when negative); corners stay
/// corners. Empty when the walls would pass through each other.
Polygon offsetWalls(const Polygon& footprint, const std::vector<double>& offsets_m);

}  // namespace handmap
