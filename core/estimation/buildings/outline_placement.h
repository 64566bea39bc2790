// The outline of a drawn building in the place of a box that was found for it.
#pragma once

#include <memory>
#include <vector>

#include "core/estimation/buildings/box.h"
#include "core/map/map.h"

namespace handmap {

/// Of a drawn polygon inside its box(); nullptr for a rectangle and for more than kMostWalls
/// corners.
std::shared_ptr<const Outline> outlineOf(const Building& drawn);

/// What was found of a building may be a part of it: the boxes whose outlines have walls at all
/// four sides of the found box, but for those that are stretched against `drawn` beyond belief.
/// `found` is numbered as the drawn box.
std::vector<Box> placements(const Box& found, const std::shared_ptr<const Outline>& outline,
                            const Rectangle& drawn);

}  // namespace handmap
