// The plane that touches the WGS 84 ellipsoid where a map lies: metres of the map to degrees and
// back.
#pragma once

#include "core/map/map.h"

namespace handmap {

/// Good to about 0.1 mm a kilometre from the origin, for the size of a drawing.
class TangentPlane {
 public:
  explicit TangentPlane(const Georeference& origin);

  Vec2 longitudeLatitude(const Vec2& in_map) const;  ///< degrees
  Vec2 inMap(const Vec2& longitude_latitude) const;  ///< metres

 private:
  Georeference origin_;
  Pose2 map_in_plane_;
  Vec2 degrees_per_metre_;  ///< east, north
};

}  // namespace handmap
