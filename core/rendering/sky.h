// What is seen where nothing near stands: sky, clouds, and far trees along the horizon.
#pragma once

#include "core/rendering/surface.h"

namespace handmap {

class Sky {
 public:
  /// `sun`: 0 overcast … 1 clear. Both cameras see the same: it is infinitely far.
  Sky(const Vec3& to_sun, float sun, std::uint64_t seed);

  /// Radiance along a ray; `pixel`: radians that a pixel covers.
  Colour colourAt(const Vec3& ray, float pixel) const;
  /// Sky, or Tree where far trees stand.
  Label labelAt(const Vec3& ray) const;

 private:
  float treeLine(float azimuth) const;  ///< its elevation as a slope

  Eigen::Vector3f to_sun_;
  float sun_;
  std::uint32_t seed_;
};

}  // namespace handmap
