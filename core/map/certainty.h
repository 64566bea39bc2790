// How sure the parts of a corrected building are.
#pragma once

#include <vector>

#include "core/map/map.h"

namespace handmap {

/// Of the sides of its box(). Where the run has not told them one by one, of the centre and the
/// width: then all of a building that was observed count as seen. All 0 without an estimate.
Sides sidesOf(const Building& building);
/// To the millimetre, as a file has them.
void setSides(Building& building, const Sides& sides);

/// Of each wall of the footprint, from corner i to i + 1: that of the side that it faces most.
std::vector<SideEstimate> wallsOf(const Building& building);

/// Which side of a box of this heading a direction points to most: 0 ahead, 1 left, 2 behind, 3
/// right.
std::size_t sideFacing(double heading_rad, const Vec2& outwards);

/// Whether something that a run saw is taken for it.
inline bool isRecognised(const Building& building) {
  return building.estimate && building.estimate->observations > 0;
}

/// Whether it is, and by one of its walls at least.
bool hasSeenWall(const Building& building);

/// 0 where the run has not said so.
inline double doubtOf(const Building& building) { return building.doubt.value_or(0.0); }
/// To the hundredth, as a file has it.
void setDoubt(Building& building, double doubt);

void copyCertainty(const Building& from, Building& to);
/// Sides and doubt: of an earlier run, or of another place of the building.
void forgetCertainty(Building& building);

}  // namespace handmap
