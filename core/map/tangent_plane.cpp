#include "core/map/tangent_plane.h"

#include <cmath>

namespace handmap {

TangentPlane::TangentPlane(const Georeference& origin)
    : origin_(origin), map_in_plane_{0.0, 0.0, origin.heading} {
  constexpr double kMajorAxis = 6378137.0;
  constexpr double kFlattening = 1.0 / 298.257223563;
  constexpr double kSquaredEccentricity = kFlattening * (2.0 - kFlattening);
  const double latitude = toRadians(origin.latitude);
  const double s = std::sin(latitude);
  const double root = std::sqrt(1.0 - kSquaredEccentricity * s * s);
  const double prime_vertical_radius = kMajorAxis / root;
  const double meridian_radius = kMajorAxis * (1.0 - kSquaredEccentricity) / (root * root * root);
  degrees_per_metre_ = {toDegrees(1.0 / (prime_vertical_radius * std::cos(latitude))),
                        toDegrees(1.0 / meridian_radius)};
}

Vec2 TangentPlane::longitudeLatitude(const Vec2& in_map) const {
  const Vec2 degrees = map_in_plane_.toOuter(in_map).cwiseProduct(degrees_per_metre_);
  return Vec2(origin_.longitude, origin_.latitude) + degrees;
}

Vec2 TangentPlane::inMap(const Vec2& longitude_latitude) const {
  const Vec2 degrees = longitude_latitude - Vec2(origin_.longitude, origin_.latitude);
  return map_in_plane_.toOwn(degrees.cwiseQuotient(degrees_per_metre_));
}

}  // namespace handmap
