// How the drawing lies where nothing of it was found.
#pragma once

#include <span>

#include "core/estimation/drawing/drawing_motion.h"

namespace handmap {

/// A building that was found.
struct Displaced {
  Vec2 drawn;          ///< its centre
  Vec2 found;          ///< map frame
  double sigma = 1.0;  ///< of a drawn place, metres
};

/// How much of what found buildings say of the whole may be said of the others: as much as each of
/// them is predicted by the rest (leave one out), 0 … 1. Errors of single buildings have nothing in
/// common, and a turn that is made up of them would throw far buildings farther off than they are
/// drawn.
double predictiveShare(const DrawingMotion& expected, std::span<const Displaced> buildings);

/// As much of that as holds so far from the nearest building that was found: what is farther than a
/// block away was drawn for itself.
double shareAt(double distance_m, double share);

/// That share of the way from what was expected to what was found, and as sure.
DrawingMotion predictedMotion(const DrawingMotion& expected, const DrawingMotion& found,
                              double share);

}  // namespace handmap
