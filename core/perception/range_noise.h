// The noise of ranges by their distance.
#pragma once

#include "core/perception/constants.h"

namespace handmap {

/// Noise of a range at distance d, one σ: offset + quadratic · d², around d + bias · d². Stereo has
/// such a bias where its disparities are off by a part of a pixel.
struct RangeNoise {
  double offset_m = perception::kNoiseOffset_m;
  double quadratic_per_m = perception::kNoiseQuadratic;
  double bias_per_m = 0.0;
  double bias(double distance_m) const { return bias_per_m * distance_m * distance_m; }
  double at(double distance_m) const {
    return offset_m + quadratic_per_m * distance_m * distance_m;
  }
};

}  // namespace handmap
