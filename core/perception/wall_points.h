// Points on walls, from stereo pairs and from range points. Robot frame, metres.
#pragma once

#include <vector>

#include "core/recording/observation.h"

namespace handmap {

struct WallPoint {
  float x;
  float y;
  float sigma;   ///< range noise along the ray, one σ, metres
  float weight;  ///< 0 … 1: how surely it is on a building
};

/// What separates walls from the ground, cars, hedges and poles.
struct WallFilter {
  double min_height_m = 1.9;  ///< above ground: cars and low hedges end below
  double max_height_m = 12.0;
  double min_extent_m = 1.0;  ///< vertical extent of what is seen in one column above min_height
  double min_range_m = 1.0;
};

/// A scan with vertical structure (a spinning lidar) is filtered by height and vertical extent in
/// cells of the plane; a planar scan (all heights within 0.3 m) is taken as it is.
std::vector<WallPoint> wallPoints(const std::vector<RangePoint>& points, double range_limit_m,
                                  const WallFilter& filter);

}  // namespace handmap
