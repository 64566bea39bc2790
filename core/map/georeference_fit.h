// Where a drawing lies on earth, from points of it whose longitude and latitude are known.
#pragma once

#include "core/map/map.h"

namespace handmap {

struct GeoPin {
  Vec2 in_map;   ///< metres
  Vec2 degrees;  ///< WGS 84 longitude, latitude
};

struct GeoreferenceFit {
  Georeference georeference;
  double scale = 1.0;  ///< metres on earth for a metre of the drawing, as the pins have it
};

/// The first pin lies where it is said; the second, which must be elsewhere, gives the turn.
GeoreferenceFit georeferenceOf(const GeoPin& first, const GeoPin& second);

}  // namespace handmap
