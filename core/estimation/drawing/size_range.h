// What a drawn building may be at all.
#pragma once

#include <algorithm>

#include "core/estimation/drawing/constants.h"

namespace handmap {

/// Metres.
struct SizeRange {
  double low, high;
};

/// Of a side that is drawn so long by somebody whose sizes are off by `sigma_m`. What is found and
/// differs by more is another thing, however well it is seen: a car, a hedge, a whole row of
/// houses.
inline SizeRange sizeRange(double drawn_m, double sigma_m) {
  return {
      std::min(drawn_m / drawing::kSizeFactor, drawing::kLeastSize_m),
      drawn_m + std::max((drawing::kSizeFactor - 1.0) * drawn_m, drawing::kSizeSigmas * sigma_m)};
}

}  // namespace handmap
