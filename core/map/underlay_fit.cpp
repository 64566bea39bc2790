#include "core/map/underlay_fit.h"

#include <cmath>

#include "core/map/map_limits.h"
#include "core/map/tangent_plane.h"

namespace handmap {

namespace {

Vec2 upwards(const Vec2& pixel) { return {pixel.x(), -pixel.y()}; }

bool fitsAMap(const Underlay& underlay) {
  return underlay.metres_per_pixel > 0.0 && underlay.metres_per_pixel <= kMaxMetresPerPixel &&
         std::abs(underlay.x) <= kMaxCoordinate && std::abs(underlay.y) <= kMaxCoordinate;
}

Vec2 meanPoint(std::span<const PointPair> pairs) {
  Vec2 sum = Vec2::Zero();
  for (const PointPair& pair : pairs) sum += pair.point;
  return sum / static_cast<double>(pairs.size());
}

}  // namespace

Vec2 pointOf(const Underlay& underlay, const Vec2& pixel) {
  const Pose2 corner{underlay.x, underlay.y, underlay.heading};
  return corner.toOuter(underlay.metres_per_pixel * upwards(pixel));
}

Vec2 pixelOf(const Underlay& underlay, const Vec2& point) {
  const Pose2 corner{underlay.x, underlay.y, underlay.heading};
  return upwards(corner.toOwn(point)) / underlay.metres_per_pixel;
}

std::optional<UnderlayFit> fitted(const Underlay& underlay, std::span<const PointPair> pairs) {
  if (pairs.size() < 2) return std::nullopt;
  Vec2 mean_pixel = Vec2::Zero();
  for (const PointPair& pair : pairs) mean_pixel += upwards(pair.pixel);
  mean_pixel /= static_cast<double>(pairs.size());
  const Vec2 mean_point = meanPoint(pairs);
  // point - mean = (c -s; s c) (pixel - mean) is linear in c and s.
  double c = 0.0;
  double s = 0.0;
  double spread = 0.0;
  for (const PointPair& pair : pairs) {
    const Vec2 from = upwards(pair.pixel) - mean_pixel;
    const Vec2 to = pair.point - mean_point;
    c += from.dot(to);
    s += cross(from, to);
    spread += from.squaredNorm();
  }
  if (!(spread > 0.0)) return std::nullopt;
  UnderlayFit fit{underlay, 0.0};
  fit.underlay.metres_per_pixel = std::hypot(c, s) / spread;
  fit.underlay.heading = std::atan2(s, c);
  const Vec2 corner = mean_point - fit.underlay.metres_per_pixel *
                                       Pose2{0.0, 0.0, fit.underlay.heading}.toOuter(mean_pixel);
  fit.underlay.x = corner.x();
  fit.underlay.y = corner.y();
  if (!fitsAMap(fit.underlay)) return std::nullopt;
  for (const PointPair& pair : pairs)
    fit.residual = std::max(fit.residual, (pointOf(fit.underlay, pair.pixel) - pair.point).norm());
  return fit;
}

std::optional<Underlay> scaled(const Underlay& underlay, const Vec2& a, const Vec2& b,
                               double length_m) {
  const double factor = length_m / (b - a).norm();
  if (!std::isfinite(factor)) return std::nullopt;
  Underlay result = underlay;
  result.metres_per_pixel *= factor;
  const Vec2 corner = a + factor * (Vec2(underlay.x, underlay.y) - a);
  result.x = corner.x();
  result.y = corner.y();
  return fitsAMap(result) ? std::optional(result) : std::nullopt;
}

std::optional<GroundedUnderlay> grounded(const Underlay& underlay, const PictureGeometry& geometry,
                                         const std::optional<Georeference>& of_map,
                                         const Vec2& middle) {
  if (geometry.pairs.empty()) return std::nullopt;
  std::vector<PointPair> pairs = geometry.pairs;
  const Vec2 mean = meanPoint(pairs);
  std::optional<Georeference> given;
  if (geometry.kind == PictureGeometry::Kind::LongitudeLatitude) {
    Georeference frame = of_map.value_or(Georeference{});
    if (!of_map) {
      const Vec2 origin = TangentPlane({mean.y(), mean.x(), 0.0, {}}).longitudeLatitude(-middle);
      frame.longitude = origin.x();
      frame.latitude = origin.y();
      if (std::abs(frame.latitude) > kMaxLatitudeDeg || std::abs(frame.longitude) > 180.0)
        return std::nullopt;
      given = frame;
    }
    const TangentPlane plane(frame);
    for (PointPair& pair : pairs) pair.point = plane.inMap(pair.point);
  } else {
    for (PointPair& pair : pairs) pair.point += middle - mean;
  }
  const auto fit = fitted(underlay, pairs);
  if (!fit) return std::nullopt;
  return GroundedUnderlay{*fit, given};
}

}  // namespace handmap
