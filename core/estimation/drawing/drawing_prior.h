// What a drawing says of the buildings that were found, where these are labelled.
#pragma once

#include <vector>

#include "core/estimation/buildings/found_box.h"
#include "core/estimation/drawing/drawing_motion.h"
#include "core/map/map.h"

namespace handmap {

/// Where the walls of labelled boxes are, but for how the drawing lies as a whole, and how they
/// stand.
struct DrawingPrior {
  struct Anchor {
    FoundId box;
    const Building* drawn;
    Uncertainty uncertainty;
  };
  std::vector<Anchor> anchors;
  DrawingMotion expected;  ///< before anything was found
  DrawingMotion motion;
  double turn = 0.0;  ///< of the drawing, where it is not as drawn
};

}  // namespace handmap
