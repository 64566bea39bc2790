// From the map frame to the scene: the same metres, in Qt's types.
#pragma once

#include <QPolygonF>

#include "core/geometry/polygon.h"

namespace handmap {

inline QPointF toScene(const Vec2& point) { return {point.x(), point.y()}; }

inline QPolygonF toScene(const Polygon& polygon) {
  QPolygonF points;
  points.reserve(static_cast<qsizetype>(polygon.size()));
  for (const Vec2& point : polygon) points.append(toScene(point));
  return points;
}

}  // namespace handmap
