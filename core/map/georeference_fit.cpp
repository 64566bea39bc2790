#include "core/map/georeference_fit.h"

#include "core/map/tangent_plane.h"

namespace handmap {

GeoreferenceFit georeferenceOf(const GeoPin& first, const GeoPin& second) {
  const Georeference at_first{first.degrees.y(), first.degrees.x(), 0.0, {}};
  const TangentPlane plane(at_first);  // x is east
  const Vec2 on_earth = plane.inMap(second.degrees);
  const Vec2 in_map = second.in_map - first.in_map;
  const double heading =
      std::atan2(on_earth.y(), on_earth.x()) - std::atan2(in_map.y(), in_map.x());
  const Vec2 origin =
      plane.longitudeLatitude(Pose2{0.0, 0.0, heading}.toOuter(Vec2(-first.in_map)));
  return {{origin.y(), origin.x(), normalizedAngle(heading), {}}, on_earth.norm() / in_map.norm()};
}

}  // namespace handmap
