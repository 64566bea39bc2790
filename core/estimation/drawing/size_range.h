// What a drawn building may be at all.
#pragma once

#include <algorithm>

namespace handmap {

/// Metres.
struct SizeRange {
  double low, high;
};

/// Of a side that is drawn so long by somebody whose sizes are off by `sigma_m`. What is found and
/// differs by more is another thing, however well it is seen: a car, a hedge, a whole row of
/// houses.
inline SizeRange sizeRange(double drawn_m, double sigma_m) {
  constexpr double kFactor = 2.0;   // sketches of real places are off by no more: METHOD.md
  constexpr double kSigmas = 3.0;   // unless they say so
  constexpr double kLeast_m = 3.0;  // a car is 1.8 m wide, hardly a house below 3; choice
  return {std::min(drawn_m / kFactor, kLeast_m),
          drawn_m + std::max((kFactor - 1.0) * drawn_m, kSigmas * sigma_m)};
}

}  // namespace handmap
