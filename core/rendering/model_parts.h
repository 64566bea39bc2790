// From things of a world to the surfaces that are seen of them. What is left to chance follows from
// the seed.
#pragma once

#include <cstdint>

#include "core/rendering/surface.h"

namespace handmap {

void addBuilding(const World& world, std::size_t building, Model& model);

/// A tree (trunk and crown) where the obstacle is slim, a bush else. `clear_m`: how far a crown may
/// reach; `leaves`: how many pieces its foliage has.
void addPlant(const Obstacle& plant, double clear_m, int leaves, std::uint64_t seed,
              std::uint32_t number, Model& model);
void addHedge(const Thing& hedge, std::uint64_t seed, std::uint32_t number, Model& model);
void addCar(const Thing& car, std::uint64_t seed, std::uint32_t number, Model& model);
void addPerson(const Thing& person, std::uint64_t seed, std::uint32_t number, Model& model);
void addSign(const Thing& sign, std::uint64_t seed, std::uint32_t number, Model& model);
void addLamp(const Thing& lamp, std::uint64_t seed, Model& model);
/// Pickets, as wide as the share of rays that it stops.
void addFence(const Thing& fence, std::uint64_t seed, std::uint32_t number, Model& model);
void addRack(const Thing& rack, std::uint64_t seed, std::uint32_t number, Model& model);

}  // namespace handmap
