// Where all buildings are, together: no return is from two of them.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/outlines/outline_search.h"

namespace handmap {

/// Area that both have, m².
double sharedArea(const Polygon& outline, const Polygon& other);

/// Of the rays that tell of a building wherever its prior lets it be.
OutlineScorer scorerFor(const OutlinePrior& prior, const PlacedRays& placed, double range_limit_m,
                        const RayOwners& owners, int building);

/// By building; nullopt: there is no place for it beside the others that the rays speak for. Each
/// is looked for by itself, then once more beside each neighbour that wants the same returns; of
/// all places those are taken that go together best (chooseModes()), first as to which thing each
/// building is, then as to where on it it stands. `owners`: what is known before. Anything where
/// `stop` was requested.
std::vector<std::optional<FittedOutline>> placesTogether(
    const std::vector<OutlinePrior>& priors, const PlacedRays& placed, double range_limit_m,
    const RayOwners& owners, std::uint64_t seed, const std::stop_token& stop = {});

}  // namespace handmap
