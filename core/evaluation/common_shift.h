// What all buildings of a map are off by together, apart from what each is off of its own: a public
// map drawn over a displaced aerial picture.
#pragma once

#include <optional>

#include "core/map/map.h"

namespace handmap {

/// Of the drawing onto what was found, one σ each.
struct CommonShift {
  Vec2 shift = Vec2::Zero();  ///< of the middle of the buildings, metres
  Vec2 shift_sigma = Vec2::Zero();
  double turn = 0.0;  ///< about that middle, radians
  double turn_sigma = 0.0;
  double own = 0.0;  ///< what a building is off by beside that, x and y each, metres
  int buildings = 0;
};

/// By the centroids of the buildings that were observed, without those that moved as no other did
/// (they were taken for something else), weighed by their σ and by what buildings are
/// off of their own, which is found with it (Paule & Mandel 1982). What the drawing says of its
/// turn and of the robot's start holds here too, and by what σ grows on the way, the way is off: as
/// far as they are off, all buildings are found off. nullopt for less than three.
std::optional<CommonShift> commonShiftOf(const Map& drawing, const Map& refined);

}  // namespace handmap
