#include "widgets/tools/tool_painting.h"

#include <QLocale>
#include <QPainter>

#include "widgets/canvas/building_handles.h"

namespace handmap {

namespace {

constexpr double kHandlePx = 8.0;

/// The middle of a side, pushed outwards so far that a note does not cover the side.
QPointF beside(const ToolPaint& canvas, const Vec2& from, const Vec2& outward) {
  const QPointF at = canvas.toDevice(from);
  QPointF away = canvas.toDevice(from + outward) - at;
  away /= std::hypot(away.x(), away.y());
  return at + QPointF(away.x() * 34.0, away.y() * 16.0);
}

}  // namespace

QString metresText(double metres) {
  return QObject::tr("%1 m").arg(QLocale::c().toString(metres, 'f', 1));
}

QString degreesText(double heading_rad) {
  return QStringLiteral("%1°").arg(
      QLocale::c().toString(toDegrees(normalizedAngle(heading_rad)), 'f', 1));
}

QString positionText(const Vec2& position) {
  return QObject::tr("x %1 m, y %2 m")
      .arg(QLocale::c().toString(position.x(), 'f', 2),
           QLocale::c().toString(position.y(), 'f', 2));
}

void paintHandle(ToolPaint& canvas, const Vec2& position, bool round) {
  QPainter& painter = canvas.painter;
  const QPointF at = canvas.toDevice(position);
  const QPointF centre(std::floor(at.x()) + 0.5, std::floor(at.y()) + 0.5);
  const QRectF square(centre.x() - kHandlePx / 2.0, centre.y() - kHandlePx / 2.0, kHandlePx,
                      kHandlePx);
  painter.setPen(QPen(canvas.colours[Role::Selection], 1.0));
  painter.setBrush(canvas.colours[Role::Background]);
  if (round)
    painter.drawEllipse(square.adjusted(-1.0, -1.0, 1.0, 1.0));
  else
    painter.drawRect(square);
}

void paintHandles(ToolPaint& canvas, const Rectangle& box) {
  const double scale = canvas.metresPerPixel();
  const Polygon corners = box.corners();
  canvas.painter.setPen(QPen(canvas.colours[Role::Selection], 1.0, Qt::DotLine));
  canvas.painter.setBrush(Qt::NoBrush);
  QPolygonF outline;
  for (const Vec2& corner : corners) outline << canvas.toDevice(corner);
  canvas.painter.drawPolygon(outline);
  canvas.painter.drawLine(canvas.toDevice(handlePosition(box, {0, 1}, scale)),
                          canvas.toDevice(handlePosition(box, {0, 0}, scale)));
  for (const Handle& handle : kHandles)
    if (hasRoom(box, handle, scale))
      paintHandle(canvas, handlePosition(box, handle, scale), handle.turns());
}

void paintOutline(ToolPaint& canvas, std::span<const Vec2> points, bool closed, Role role) {
  QPolygonF outline;
  for (const Vec2& point : points) outline << canvas.toDevice(point);
  canvas.painter.setPen(canvas.colours.pen(role));
  if (closed) {
    canvas.painter.setBrush(canvas.colours.brush(role));
    canvas.painter.drawPolygon(outline);
  } else {
    canvas.painter.drawPolyline(outline);
  }
}

void paintSizes(ToolPaint& canvas, const Rectangle& box) {
  const Vec2 along = unitVector(box.heading);
  const Vec2 across = perpendicular(along);
  paintNote(canvas, beside(canvas, box.centre - across * box.depth / 2.0, -across),
            metresText(box.width));
  paintNote(canvas, beside(canvas, box.centre + along * box.width / 2.0, along),
            metresText(box.depth));
}

void paintNote(ToolPaint& canvas, const QPointF& centre, const QString& text) {
  QPainter& painter = canvas.painter;
  QRectF box = painter.fontMetrics().boundingRect(text).toRectF();
  box.adjust(-5.0, -2.0, 5.0, 2.0);
  box.moveCenter(centre);
  painter.setPen(Qt::NoPen);
  painter.setBrush(canvas.colours[Role::Selection]);
  painter.drawRoundedRect(box, 3.0, 3.0);
  painter.setPen(canvas.colours[Role::Background]);
  painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace handmap
