// Small signs on the canvas, in device pixels.
#pragma once

#include <QLineF>
#include <QPainter>
#include <QPolygonF>

#include "widgets/style/colours.h"

namespace handmap {

/// Where the robot starts: a disc and an arrow. `direction` is a vector in device pixels.
void paintStartSymbol(QPainter& painter, const QPointF& at, const QPointF& direction,
                      const QColor& ink, const QColor& ground);
void paintLandmarkSymbol(QPainter& painter, const QPointF& at, const QColor& ink,
                         const QColor& ground);
/// A padlock: nobody moves this building by hand.
void paintLockSymbol(QPainter& painter, const QPointF& centre, const QColor& ink);
/// A pin: a run must not move it.
void paintFixedSymbol(QPainter& painter, const QPointF& centre, const QColor& ink);
void paintRoute(QPainter& painter, const QPolygonF& points, const QPen& pen, const QColor& ground);
/// A shaft in the pen of the painter, the head of two strokes.
void paintArrow(QPainter& painter, const QLineF& line);
/// Text, centred; on a faint ground of its own where what is below may be anything.
void paintLabel(QPainter& painter, const QPointF& centre, const QString& text,
                const Colours& colours, bool on_ground);

}  // namespace handmap
