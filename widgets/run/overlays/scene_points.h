// From the map frame to the scene: the same metres, in Qt's types.
#pragma once

#include <QLineF>
#include <QList>
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

/// Side i leads from corner i to the next. A painter strokes lines in a third of the time that a
/// path of the same sides takes.
inline void appendSides(const QPolygonF& corners, QList<QLineF>& sides) {
  for (qsizetype i = 0; i < corners.size(); ++i) {
    sides.append({corners[i], corners[(i + 1) % corners.size()]});
  }
}

}  // namespace handmap
