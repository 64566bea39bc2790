#include "widgets/tools/geo_pin_tool.h"

#include <QPainter>

#include "widgets/style/colours.h"
#include "widgets/tools/tool_painting.h"

namespace handmap {

namespace {

constexpr double kLeastApart_m = 1.0;  // nearer ones tell nothing of the turn
constexpr double kPinPx = 6.0;

}  // namespace

QString GeoPinTool::hint() const {
  if (pins_.empty()) return tr("Click a place whose latitude and longitude you know");
  return tr("Click a second place, far from the first one · Backspace takes the first back");
}

bool GeoPinTool::cancel() {
  const bool was_busy = isBusy();
  pins_.clear();
  if (was_busy) Q_EMIT changed();
  return was_busy;
}

void GeoPinTool::takeBack() { cancel(); }

void GeoPinTool::press(const ToolEvent& event) { Q_EMIT placed(event.snapped); }

void GeoPinTool::pin(const GeoPin& pin) {
  if (!pins_.empty() && (pins_.front().in_map - pin.in_map).norm() < kLeastApart_m) return;
  pins_.push_back(pin);
  Q_EMIT changed();
  if (pins_.size() < 2) return;
  const GeoPin first = pins_.front();
  pins_.clear();
  Q_EMIT complete(first, pin);
  Q_EMIT finished();
}

void GeoPinTool::paint(ToolPaint& canvas) const {
  canvas.painter.setPen(canvas.colours.pen(Role::Preview));
  canvas.painter.setBrush(canvas.colours.brush(Role::Preview));
  for (const GeoPin& pin : pins_) {
    const QPointF at = canvas.toDevice(pin.in_map);
    canvas.painter.drawEllipse(at, kPinPx, kPinPx);
    paintNote(canvas, at + QPointF(0.0, 24.0),
              tr("%1°, %2°").arg(pin.degrees.y(), 0, 'f', 5).arg(pin.degrees.x(), 0, 'f', 5));
  }
}

}  // namespace handmap
