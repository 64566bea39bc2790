// A drawn building corrected by the one that was found for it.
#pragma once

#include "core/estimation/drawing/drawn_box.h"

namespace handmap {

/// The building after the run: the drawn one as the motion predicts it, corrected by the found one
/// where there is one.
struct RefinedBuilding {
  Box walls;
  DrawnBox::Covariance covariance;  ///< of walls.reach
  Rectangle box() const { return walls.rectangle(); }
  Estimate estimate;
};
RefinedBuilding refinedBuilding(const Building& building, const Uncertainty& uncertainty,
                                const DrawingMotion& motion, const FoundBox* found);

}  // namespace handmap
