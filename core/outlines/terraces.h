// Houses wall to wall: one surface; the drawing and the steps of its faces say where a house ends.
#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/outlines/outline_task.h"

namespace handmap {

/// How well is told which part of its row a house is.
struct RowPlace {
  Vec2 along = Vec2::UnitX();
  double from_sigma = 0.0, to_sigma = 0.0;  ///< of where it ends along that, metres
  double doubt = 0.0;                       ///< that it is another part, 0 … 1
};

/// A house of a terrace, looked for as drawn whatever was found for it.
struct TerraceHouse {
  std::size_t building;
  OutlinePrior prior;
  std::optional<FittedOutline> place;  ///< none: it is none of the terrace, as it seemed
  RowPlace in_row;
};

/// Places wall to wall are a terrace, with what is seen on from them; one house alone takes as much
/// of it as it may. It is divided (row_division.h) among those of the houses that are drawn there,
/// and things that nobody drew, that make it most probable, by how they are drawn and by the steps
/// of its faces. The houses of those that were divided.
std::vector<TerraceHouse> dividedTerraces(const std::vector<OutlineTask>& tasks,
                                          const std::vector<std::optional<FittedOutline>>& places,
                                          const PlacedRays& placed, double range_limit_m,
                                          const std::stop_token& stop);

}  // namespace handmap
