// Houses wall to wall: one surface, of which the drawing alone says where a house ends.
#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/outlines/outline_task.h"

namespace handmap {

/// A house of a terrace, looked for as drawn whatever was found for it.
struct TerraceHouse {
  std::size_t building;
  OutlinePrior prior;
  FittedOutline place;
};

/// Places wall to wall are a terrace. Others that are drawn on it, and have no place or one that is
/// worth less, are to be on it too: it is divided among them all, in the order and by the sizes of
/// the drawing, as far as that makes it more probable and leaves the evidence. One house alone
/// takes as much of a wall without ends as it may. The houses of those that were divided.
std::vector<TerraceHouse> dividedTerraces(const std::vector<OutlineTask>& tasks,
                                          const std::vector<std::optional<FittedOutline>>& places,
                                          const PlacedRays& placed, double range_limit_m,
                                          const std::stop_token& stop);

}  // namespace handmap
