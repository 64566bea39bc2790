// Simple polygons: the footprints of buildings.
#pragma once

#include <vector>

#include "core/geometry/pose2.h"

namespace handmap {

/// Counter-clockwise corners in metres, closed from the last to the first.
using Polygon = std::vector<Vec2>;

struct Segment {
  Vec2 a;
  Vec2 b;
  double length() const { return (b - a).norm(); }
};

struct Bounds {
  Vec2 low;
  Vec2 high;
  bool overlaps(const Bounds& other) const {
    return (low.array() < other.high.array()).all() && (other.low.array() < high.array()).all();
  }
};

/// Centre, size along the heading (width) and across it (depth), heading; metres, radians.
struct Rectangle {
  Vec2 centre = Vec2::Zero();
  double width = 0.0;
  double depth = 0.0;
  double heading = 0.0;

  Polygon corners() const;
  bool operator==(const Rectangle&) const = default;
};

/// Positive for counter-clockwise corners.
double signedArea(const Polygon& polygon);
Vec2 centroid(const Polygon& polygon);
Bounds boundsOf(const Polygon& polygon);  ///< polygon must not be empty
/// No edge meets another but at their common corner, and the area is not zero.
bool isSimple(const Polygon& polygon);
bool isConvex(const Polygon& polygon);
bool contains(const Polygon& polygon, const Vec2& point);
double distanceTo(const Polygon& polygon, const Vec2& point);  ///< 0 inside
double distanceTo(const Segment& segment, const Vec2& point);
/// Area common to two simple polygons, m².
double intersectionArea(const Polygon& a, const Polygon& b);
double intersectionOverUnion(const Polygon& a, const Polygon& b);
/// Whether two simple polygons share more than a boundary. Fast for the convex and the far apart.
bool overlap(const Polygon& a, const Polygon& b);
/// The smallest rectangle of the given heading around the polygon.
Rectangle boundingRectangle(const Polygon& polygon, double heading_rad);
/// The heading in [0, π/2) of the wall whose bounding rectangle is smallest.
double principalHeading(const Polygon& polygon);

}  // namespace handmap
