#include "widgets/canvas/rulers.h"

#include <QLocale>
#include <cmath>

namespace handmap {

namespace {

constexpr double kMinLinePx = 9.0;
constexpr double kBarPx = 90.0;
constexpr double kMarginPx = 14.0;

struct Axis {
  bool vertical_lines;
  double low;  ///< metres shown
  double high;
};

QPointF deviceAt(const QTransform& to_device, const Axis& axis, double metres) {
  return to_device.map(axis.vertical_lines ? QPointF(metres, 0.0) : QPointF(0.0, metres));
}

/// A map that is turned has no lines that lie on pixels.
bool isTurned(const QTransform& to_device) { return std::abs(to_device.m12()) > 1e-9; }

void paintLines(QPainter& painter, const QTransform& to_device, const QRectF& area,
                const Axis& axis, const Axis& other, double step, const QColor& colour) {
  painter.setPen(colour);
  for (double i = std::ceil(axis.low / step); i * step <= axis.high; ++i) {
    const double metres = i * step;
    const QPointF at = deviceAt(to_device, axis, metres);
    if (isTurned(to_device)) {
      painter.drawLine(to_device.map(axis.vertical_lines
                                         ? QLineF(metres, other.low, metres, other.high)
                                         : QLineF(other.low, metres, other.high, metres)));
    } else if (axis.vertical_lines) {  // a rectangle takes a quarter of the time of a line
      painter.fillRect(QRectF(std::floor(at.x()), area.top(), 1.0, area.height()), colour);
    } else {
      painter.fillRect(QRectF(area.left(), std::floor(at.y()), area.width(), 1.0), colour);
    }
  }
}

void paintNumbers(QPainter& painter, const QTransform& to_device, const QRectF& area,
                  const Axis& axis, double step) {
  const QFontMetrics metrics = painter.fontMetrics();
  for (double i = std::ceil(axis.low / step); i * step <= axis.high; ++i) {
    const QPointF at = deviceAt(to_device, axis, i * step);
    const QString text = QLocale::c().toString(i * step, 'g', 10);
    if (axis.vertical_lines)
      painter.drawText(QPointF(at.x() + 4.0, area.top() + metrics.ascent() + 2.0), text);
    else if (at.y() > area.top() + 2.0 * metrics.height())
      painter.drawText(QPointF(area.left() + 4.0, at.y() - 3.0), text);
  }
}

QString lengthText(double metres) {
  if (metres >= 1000.0) return QStringLiteral("%1 km").arg(metres / 1000.0);
  if (metres >= 1.0) return QStringLiteral("%1 m").arg(metres);
  return QStringLiteral("%1 cm").arg(metres * 100.0);
}

}  // namespace

double roundedStep(double metres) {
  const double power = std::pow(10.0, std::floor(std::log10(metres)));
  for (const double digit : {1.0, 2.0, 5.0})
    if (digit * power >= metres * (1.0 - 1e-9)) return digit * power;
  return 10.0 * power;
}

void paintGrid(QPainter& painter, const QTransform& to_device, const QRectF& area,
               const Colours& colours) {
  const QRectF metres = to_device.inverted().mapRect(area);
  const double step = roundedStep(kMinLinePx / std::hypot(to_device.m11(), to_device.m12()));
  const double major = 10.0 * step;
  const Axis axes[] = {{true, metres.left(), metres.right()},
                       {false, metres.top(), metres.bottom()}};
  for (const auto& [role, spacing] :
       {std::pair{Role::GridLine, step}, std::pair{Role::GridLineMajor, major}}) {
    paintLines(painter, to_device, area, axes[0], axes[1], spacing, colours[role]);
    paintLines(painter, to_device, area, axes[1], axes[0], spacing, colours[role]);
  }
  painter.setPen(colours.pen(Role::Axis));
  const QPointF origin = to_device.map(QPointF());
  const QPointF centre(std::floor(origin.x()) + 0.5, std::floor(origin.y()) + 0.5);
  if (area.contains(centre)) {
    painter.drawLine(centre - QPointF(8.0, 0.0), centre + QPointF(8.0, 0.0));
    painter.drawLine(centre - QPointF(0.0, 8.0), centre + QPointF(0.0, 8.0));
  }
  if (isTurned(to_device)) return;
  for (const Axis& axis : axes) paintNumbers(painter, to_device, area, axis, major);
}

void paintScaleBar(QPainter& painter, double pixels_per_metre, const QRectF& area,
                   const Colours& colours) {
  const double length = roundedStep(kBarPx / pixels_per_metre);
  const double width = std::round(length * pixels_per_metre);
  const double left = std::floor(area.right() - kMarginPx - width) + 0.5;
  const double y = std::floor(area.bottom() - kMarginPx) + 0.5;
  const QString text = lengthText(length);

  QColor ground = colours[Role::Background];
  ground.setAlpha(200);
  const double height = painter.fontMetrics().height();
  painter.fillRect(QRectF(left - 8.0, y - height - 8.0, width + 16.0, height + 14.0), ground);
  painter.setPen(QPen(colours[Role::Text], 1.0));
  const QPointF ends[] = {{left, y - 5.0}, {left, y}, {left + width, y}, {left + width, y - 5.0}};
  painter.drawPolyline(ends, 4);
  painter.drawText(QRectF(left, y - height - 4.0, width, height),
                   Qt::AlignCenter | Qt::TextDontClip, text);
}

}  // namespace handmap
