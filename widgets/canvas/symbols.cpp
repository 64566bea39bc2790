#include "widgets/canvas/symbols.h"

#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace handmap {

namespace {

QPolygonF arrowHead(const QPointF& tip, const QPointF& unit, double length) {
  const QPointF side(-unit.y(), unit.x());
  const QPointF foot = tip - unit * length;
  return {{tip, foot + side * (0.45 * length), foot - side * (0.45 * length)}};
}

QPointF unitOf(const QPointF& direction) {
  const double length = std::hypot(direction.x(), direction.y());
  return length > 0.0 ? direction / length : QPointF(1.0, 0.0);
}

}  // namespace

void paintStartSymbol(QPainter& painter, const QPointF& at, const QPointF& direction,
                      const QColor& ink, const QColor& ground) {
  const QPointF unit = unitOf(direction);
  const QPointF tip = at + unit * 28.0;
  for (const auto& [colour, extra] : {std::pair{ground, 3.0}, std::pair{ink, 0.0}}) {
    painter.setPen(QPen(colour, 2.5 + extra, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(at, tip - unit * 6.0);
    painter.setPen(QPen(colour, std::max(extra, 0.1), Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter.setBrush(colour);
    painter.drawPolygon(arrowHead(tip, unit, 11.0));
    painter.drawEllipse(at, 6.5, 6.5);
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(ground);
  painter.drawEllipse(at, 2.5, 2.5);
}

void paintLandmarkSymbol(QPainter& painter, const QPointF& at, const QColor& ink,
                         const QColor& ground) {
  painter.setPen(QPen(ground, 1.5));
  painter.setBrush(ink);
  painter.drawPolygon(QPolygonF{{at + QPointF(0.0, -7.0), at + QPointF(6.0, 0.0),
                                 at + QPointF(0.0, 7.0), at + QPointF(-6.0, 0.0)}});
}

void paintLockSymbol(QPainter& painter, const QPointF& centre, const QColor& ink) {
  QPainterPath bow;
  bow.moveTo(centre + QPointF(-2.5, -0.5));
  bow.arcTo(QRectF(centre + QPointF(-2.5, -5.5), QSizeF(5.0, 6.0)), 180.0, -180.0);
  bow.lineTo(centre + QPointF(2.5, -0.5));
  painter.setPen(QPen(ink, 1.4));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(bow);
  painter.fillRect(QRectF(centre + QPointF(-4.5, -0.5), QSizeF(9.0, 6.5)), ink);
}

void paintFixedSymbol(QPainter& painter, const QPointF& centre, const QColor& ink) {
  painter.setPen(QPen(ink, 1.4));
  painter.drawLine(centre + QPointF(0.0, 0.0), centre + QPointF(0.0, 6.0));
  painter.setBrush(ink);
  painter.drawEllipse(centre + QPointF(0.0, -2.0), 3.0, 3.0);
}

void paintRoute(QPainter& painter, const QPolygonF& points, const QPen& pen, const QColor& ground) {
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  painter.drawPolyline(points);
  QPen solid = pen;
  solid.setStyle(Qt::SolidLine);
  painter.setPen(solid);
  painter.setBrush(ground);
  for (const QPointF& point : points) painter.drawEllipse(point, 3.0, 3.0);
  if (points.size() < 2) return;
  const QPointF& tip = points.last();
  painter.setBrush(pen.color());
  painter.drawPolygon(arrowHead(tip, unitOf(tip - points[points.size() - 2]), 11.0));
}

void paintArrow(QPainter& painter, const QLineF& line) {
  constexpr double kHeadPx = 9.0;
  const QPen pen = painter.pen();
  painter.drawLine(line);
  QLineF barb(line.p2(), line.p1());
  barb.setLength(std::min(kHeadPx, 0.6 * line.length()));
  QPen solid = pen;
  solid.setStyle(Qt::SolidLine);
  painter.setPen(solid);
  for (const double turn : {-25.0, 25.0}) {
    QLineF side = barb;
    side.setAngle(barb.angle() + turn);
    painter.drawLine(side);
  }
  painter.setPen(pen);
}

void paintLabel(QPainter& painter, const QPointF& centre, const QString& text,
                const Colours& colours, bool on_ground) {
  QRectF box = painter.fontMetrics().boundingRect(text).toRectF().adjusted(-2.0, 0.0, 2.0, 0.0);
  box.moveCenter(centre);
  box.moveTopLeft(QPointF(std::round(box.left()), std::round(box.top())));
  QColor ground = colours[Role::TextHalo];
  ground.setAlpha(150);
  if (on_ground) painter.fillRect(box, ground);
  painter.setPen(colours[Role::Text]);
  painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, text);
}

}  // namespace handmap
