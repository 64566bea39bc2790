// Houses wall to wall: one surface, of which the drawing alone says where a house ends.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/outlines/outline_task.h"

namespace handmap {

/// A house of a terrace, looked for as drawn whatever was found for it.
struct TerraceHouse {
  std::size_t building;
  OutlinePrior prior;
  FittedOutline place;
};

/// Where building `whole` has a place on which others are drawn that have none: the place divided
/// among them all, in the order and by the sizes of the drawing. One alone takes as much of a wall
/// without ends as it may. Empty where there are no others, or where drawing or rays speak for the
/// place as it is.
std::vector<TerraceHouse> dividedTerrace(std::size_t whole, const std::vector<OutlineTask>& tasks,
                                         const std::vector<std::optional<FittedOutline>>& places,
                                         const PlacedRays& placed, double range_limit_m);

}  // namespace handmap
