// A drawn building that is to be fitted, and how it may be wrong.
#pragma once

#include "core/map/map.h"
#include "core/outlines/outline_search.h"

namespace handmap {

/// A building to be fitted.
struct OutlineTask {
  Polygon as_drawn;
  Polygon drawn;               ///< the same, or where what was found has it
  Polygon start;               ///< where it is looked for first
  double shift_m = 0.0;        ///< how far that may be off, one σ
  double drawn_shift_m = 0.0;  ///< how far the drawn place may be off, one σ
  double size_m = 0.0;         ///< how far its sizes may, one σ
  WholeUncertainty whole;      ///< of a drawing that it was not carried along with, where stated
  bool rectangle = false;      ///< stays one
  bool labelled = false;       ///< something was found at the start that is taken for it
};

/// Along its longest wall, radians.
double headingOf(const Polygon& outline);

/// Of the start: how people draw what they know (README, Priors).
OutlinePrior priorOf(const OutlineTask& task);

/// The same building as if nothing had been found for it.
OutlineTask asDrawn(OutlineTask task);

}  // namespace handmap
