#include "core/geometry/polygon.h"

#include <algorithm>
#include <limits>

#include <polyclipping/clipper.hpp>

namespace handmap {

namespace {

/// Clipper counts in integers: micrometres.
constexpr double kUnitsPerMetre = 1e6;

ClipperLib::Path clipperPath(const Polygon& polygon, const Vec2& origin) {
  ClipperLib::Path path;
  for (const Vec2& corner : polygon) {
    const Vec2 units = (corner - origin) * kUnitsPerMetre;
    path.emplace_back(std::llround(units.x()), std::llround(units.y()));
  }
  return path;
}

Segment edge(const Polygon& polygon, std::size_t i) {
  return {polygon[i], polygon[(i + 1) % polygon.size()]};
}

/// Shared walls that rounding makes meet by less than this (metres) do not overlap.
constexpr double kTouching = 1e-6;

/// Whether an edge of `a` has all of `b` on its outer side.
bool hasSeparatingEdge(const Polygon& a, const Polygon& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Segment e = edge(a, i);
    const bool apart = std::all_of(b.begin(), b.end(), [&](const Vec2& corner) {
      return cross(e.b - e.a, corner - e.a) <= kTouching * e.length();
    });
    if (apart) return true;
  }
  return false;
}

/// The side of the line through `line` that `point` lies on: -1, 0 or 1.
int sideOf(const Segment& line, const Vec2& point) {
  const double side = cross(line.b - line.a, point - line.a);
  return (side > 0.0) - (side < 0.0);
}

/// Whether two segments have a point in common, their ends included.
bool meet(const Segment& s, const Segment& t) {
  const bool boxes_touch = (s.a.cwiseMin(s.b).array() <= t.a.cwiseMax(t.b).array()).all() &&
                           (t.a.cwiseMin(t.b).array() <= s.a.cwiseMax(s.b).array()).all();
  return boxes_touch && sideOf(s, t.a) * sideOf(s, t.b) <= 0 &&
         sideOf(t, s.a) * sideOf(t, s.b) <= 0;
}

bool foldsBack(const Segment& wall, const Segment& next) {
  return sideOf(wall, next.b) == 0 && (wall.b - wall.a).dot(next.b - next.a) < 0.0;
}

}  // namespace

bool isConvex(const Polygon& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Segment first = edge(polygon, i);
    const Segment second = edge(polygon, (i + 1) % polygon.size());
    if (cross(first.b - first.a, second.b - second.a) < 0.0) return false;
  }
  return true;
}

Polygon Rectangle::corners() const {
  const Vec2 along = unitVector(heading) * (width / 2.0);
  const Vec2 across = perpendicular(unitVector(heading)) * (depth / 2.0);
  return {centre - along - across, centre + along - across, centre + along + across,
          centre - along + across};
}

double signedArea(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Segment e = edge(polygon, i);
    twice += cross(e.a, e.b);
  }
  return twice / 2.0;
}

Vec2 centroid(const Polygon& polygon) {
  // Around the first corner, so that far from the origin no digits are lost.
  const Vec2& origin = polygon.front();
  Vec2 moment = Vec2::Zero();
  double twice_area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = edge(polygon, i).a - origin;
    const Vec2 b = edge(polygon, i).b - origin;
    moment += cross(a, b) * (a + b) / 3.0;
    twice_area += cross(a, b);
  }
  return origin + moment / twice_area;
}

Bounds boundsOf(const Polygon& polygon) {
  Bounds bounds{polygon.front(), polygon.front()};
  for (const Vec2& corner : polygon) {
    bounds.low = bounds.low.cwiseMin(corner);
    bounds.high = bounds.high.cwiseMax(corner);
  }
  return bounds;
}

bool isSimple(const Polygon& polygon) {
  if (polygon.size() < 3) return false;
  const Vec2 size = boundsOf(polygon).high - boundsOf(polygon).low;
  if (std::abs(signedArea(polygon)) <= 1e-12 * size.squaredNorm()) return false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Segment wall = edge(polygon, i);
    if (wall.a == wall.b || foldsBack(wall, edge(polygon, (i + 1) % polygon.size()))) return false;
    for (std::size_t j = i + 2; j < polygon.size(); ++j) {
      const bool neighbours = i == 0 && j + 1 == polygon.size();
      if (!neighbours && meet(wall, edge(polygon, j))) return false;
    }
  }
  return true;
}

bool contains(const Polygon& polygon, const Vec2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Segment e = edge(polygon, i);
    if ((e.a.y() > point.y()) == (e.b.y() > point.y())) continue;
    const double x = e.a.x() + (point.y() - e.a.y()) / (e.b.y() - e.a.y()) * (e.b.x() - e.a.x());
    if (point.x() < x) inside = !inside;
  }
  return inside;
}

double distanceTo(const Segment& segment, const Vec2& point) {
  const Vec2 direction = segment.b - segment.a;
  const double squared = direction.squaredNorm();
  const double t = squared > 0.0 ? (point - segment.a).dot(direction) / squared : 0.0;
  return (segment.a + std::clamp(t, 0.0, 1.0) * direction - point).norm();
}

double distanceTo(const Polygon& polygon, const Vec2& point) {
  if (contains(polygon, point)) return 0.0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    nearest = std::min(nearest, distanceTo(edge(polygon, i), point));
  }
  return nearest;
}

double intersectionArea(const Polygon& a, const Polygon& b) {
  if (!boundsOf(a).overlaps(boundsOf(b))) return 0.0;
  const Vec2& origin = a.front();
  ClipperLib::Clipper clipper;
  clipper.AddPath(clipperPath(a, origin), ClipperLib::ptSubject, true);
  clipper.AddPath(clipperPath(b, origin), ClipperLib::ptClip, true);
  ClipperLib::Paths pieces;
  clipper.Execute(ClipperLib::ctIntersection, pieces, ClipperLib::pftNonZero,
                  ClipperLib::pftNonZero);
  double area = 0.0;
  for (const ClipperLib::Path& piece : pieces) area += ClipperLib::Area(piece);
  return area / (kUnitsPerMetre * kUnitsPerMetre);
}

double intersectionOverUnion(const Polygon& a, const Polygon& b) {
  const double common = intersectionArea(a, b);
  const double joint = std::abs(signedArea(a)) + std::abs(signedArea(b)) - common;
  return joint > 0.0 ? common / joint : 0.0;
}

bool overlap(const Polygon& a, const Polygon& b) {
  if (!boundsOf(a).overlaps(boundsOf(b))) return false;
  // The test by separating edges decides for convex polygons and is a shortcut for all others.
  const bool a_is_convex = isConvex(a);
  const bool b_is_convex = isConvex(b);
  if (a_is_convex && hasSeparatingEdge(a, b)) return false;
  if (b_is_convex && hasSeparatingEdge(b, a)) return false;
  return (a_is_convex && b_is_convex) || intersectionArea(a, b) > kTouching;
}

Rectangle boundingRectangle(const Polygon& polygon, double heading_rad) {
  const Pose2 frame{0.0, 0.0, heading_rad};
  Polygon turned = polygon;
  for (Vec2& corner : turned) corner = frame.toOwn(corner);
  const Bounds bounds = boundsOf(turned);
  const Vec2 size = bounds.high - bounds.low;
  return {frame.toOuter((bounds.low + bounds.high) / 2.0), size.x(), size.y(), heading_rad};
}

double principalHeading(const Polygon& polygon) {
  double best_heading = 0.0;
  double best_area = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 direction = edge(polygon, i).b - edge(polygon, i).a;
    double heading = std::fmod(std::atan2(direction.y(), direction.x()) + 2.0 * kPi, kPi / 2.0);
    if (heading > kPi / 2.0 - 1e-9) heading = 0.0;
    const Rectangle box = boundingRectangle(polygon, heading);
    if (box.width * box.depth < best_area - 1e-9) {
      best_area = box.width * box.depth;
      best_heading = heading;
    }
  }
  return best_heading;
}

}  // namespace handmap
