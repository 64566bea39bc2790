// Points on walls, as they come from stereo pairs and from range points. Robot frame, metres.
#pragma once

#include "core/perception/constants.h"

namespace handmap {

struct WallPoint {
  float x;
  float y;
  float sigma;   ///< range noise along the ray, one σ, metres
  float weight;  ///< 0 … 1: how surely it is on a building
};

/// What separates walls from the ground, cars, hedges, fences and poles.
struct WallFilter {
  double min_height_m =
      perception::kLeastHeight_m;  ///< above ground: cars and low hedges end below
  double max_height_m = perception::kMostHeight_m;
  double min_extent_m = perception::kLeastExtent_m;  ///< vertical extent of what is seen in one
                                                     ///< column above min_height
  double min_range_m = perception::kNearestWall_m;
  double sensor_height_m =
      perception::kSensorHeight_m;  ///< of a range sensor; a metre more or less makes no difference

  /// What is known to end lower is no wall of a building.
  double leastTop() const { return min_height_m + min_extent_m; }
};

}  // namespace handmap
