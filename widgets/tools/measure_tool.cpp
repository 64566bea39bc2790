#include "widgets/tools/measure_tool.h"

#include "widgets/tools/tool_painting.h"

namespace handmap {

QString MeasureTool::hint() const {
  if (placed().empty()) return tr("Click from point to point to measure · Esc: leave");
  return tr("The next point · Enter or a double click: done · Backspace: one back");
}

bool MeasureTool::cancel() {
  const bool had_result = !measured_.empty();
  measured_.clear();
  if (had_result) Q_EMIT changed();
  return DrawingTool::cancel() || had_result;
}

void MeasureTool::press(const ToolEvent& event) {
  measured_.clear();
  DrawingTool::press(event);
}

void MeasureTool::finish() {
  std::vector<Vec2> points = placed();
  cancel();
  measured_ = std::move(points);
  Q_EMIT changed();
}

void MeasureTool::paint(ToolPaint& canvas) const {
  const std::vector<Vec2> points = placed().empty() ? measured_ : withNext();
  if (!points.empty()) {
    paintOutline(canvas, points, false, Role::Preview);
    double total = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double length = (points[i] - points[i - 1]).norm();
      total += length;
      if (length > 0.0)
        paintNote(canvas, canvas.toDevice((points[i] + points[i - 1]) / 2.0), metresText(length));
    }
    for (const Vec2& point : points) paintHandle(canvas, point);
    QString text = tr("in all %1").arg(metresText(total));
    if (points.size() > 2 && isSimple(points))
      text += tr("   %1 m²").arg(std::abs(signedArea(points)), 0, 'f', 1);
    if (points.size() > 2)
      paintNote(canvas, canvas.toDevice(points.back()) + QPointF(0.0, 48.0), text);
  }
  DrawingTool::paint(canvas);
}

}  // namespace handmap
