// How sure the parts of a corrected building are, by what the run has said of it.
#pragma once

#include <array>
#include <vector>

#include "core/map/map.h"

namespace handmap {

/// How sure one side of a building is, across it.
struct SideEstimate {
  double sigma = 0.0;  ///< metres
  bool seen = false;   ///< false: it stands where the drawing has it from the other sides
  bool operator==(const SideEstimate&) const = default;
};

/// Side k of a box() has the outward normal heading + k · π/2.
using Sides = std::array<SideEstimate, 4>;

/// Of the sides of its box(). Where the run has not told them one by one, of the centre and the
/// width: then all of a building that was observed count as seen. All 0 without an estimate.
Sides sidesOf(const Building& building);
/// They are kept as members of the building: "wall_sigma_m" and "walls_seen".
void setSides(Building& building, const Sides& sides);

/// Of each wall of the footprint, from corner i to i + 1: that of the side that it faces most.
std::vector<SideEstimate> wallsOf(const Building& building);

/// Which side of a box of this heading a direction points to most: 0 ahead, 1 left, 2 behind, 3
/// right.
std::size_t sideFacing(double heading_rad, const Vec2& outwards);

/// That it is another building or is not there, 0 … 1; 0 where the run has not said so.
double doubtOf(const Building& building);
/// Kept as the member "doubtful".
void setDoubt(Building& building, double doubt);

void copyCertainty(const Building& from, Building& to);
/// Of an earlier run, or of another place of the building.
void forgetSides(Building& building);
/// Sides and doubt.
void forgetCertainty(Building& building);

}  // namespace handmap
