// The ground near one place: road, pavement, gardens.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/rendering/surface.h"

namespace handmap {

/// A road follows the route: 4 m to the kerb on either side, then 1.4 m of pavement.
class GroundMap {
 public:
  GroundMap(const std::vector<Vec2>& route, const Vec2& centre, std::uint64_t seed);

  Label labelAt(float x, float y) const;
  /// Reflectance where a pixel covers `pixel` metres.
  Colour colourAt(float x, float y, float pixel) const;

 private:
  float sampled(const cv::Mat1f& map, float x, float y, float outside) const;
  Colour roadAt(float x, float y, float pixel) const;
  Colour gardenAt(float x, float y, float pixel) const;

  Vec2 low_;  ///< of the square, map frame
  std::uint32_t seed_;
  cv::Mat1f road_;  ///< metres from the middle of the road
};

}  // namespace handmap
