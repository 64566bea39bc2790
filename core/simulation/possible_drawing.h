// Drawings that are wrong as told and yet possible.
#pragma once

#include <functional>
#include <vector>

#include "core/base/random.h"
#include "core/simulation/world.h"

namespace handmap {

/// A building of the truth drawn anew where all are drawn as given.
using Redraw = std::function<Building(std::size_t building, const std::vector<Building>& drawn,
                                      RandomStream& random)>;

/// The truth with each building drawn anew time and again: Gibbs sampling, so the errors are
/// distributed as `redraw` has them, cut off where a drawing is impossible or does not keep what it
/// has to; see perturbed().
Map possibleDrawing(const Map& truth, const Redraw& redraw, std::uint64_t seed, Keeping keeping);

}  // namespace handmap
