// Which closed shapes of a drawing are buildings.
#pragma once

#include "core/paper/candidates.h"

namespace handmap {

/// Of each candidate, 0 … 1: that it is a building and neither a block between roads, a road, a
/// letter, the frame of the page nor what is left between other shapes.
std::vector<double> confidences(const std::vector<Candidate>& candidates, const Ink& ink,
                                const PageScale& scale);

}  // namespace handmap
