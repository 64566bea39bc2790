#include "widgets/canvas/tools/route_tool.h"

#include "widgets/canvas/tools/tool_painting.h"

namespace handmap {

QString RouteTool::hint() const {
  if (document().map().route.empty()) return tr("Click the points of the robot's way");
  return tr("Click to lengthen the route · Backspace: one point back · Esc: done");
}

void RouteTool::press(const ToolEvent& event) {
  std::vector<Vec2> route = document().map().route;
  if (!route.empty() && route.back() == event.snapped) return;
  route.push_back(event.snapped);
  document().setRoute(std::move(route));
  document().setSelection({kRouteKey});
  Q_EMIT changed();
}

void RouteTool::move(const ToolEvent& event) {
  pointer_ = event.snapped;
  if (!document().map().route.empty()) Q_EMIT changed();
}

bool RouteTool::key(const ToolKey& key) {
  std::vector<Vec2> route = document().map().route;
  if (key.key != Qt::Key_Backspace || route.empty()) return false;
  route.pop_back();
  document().setRoute(std::move(route));
  Q_EMIT changed();
  return true;
}

void RouteTool::paint(ToolPaint& canvas) const {
  const std::vector<Vec2>& route = document().map().route;
  if (route.empty() || !pointer_) return;
  const Vec2 leg[] = {route.back(), *pointer_};
  paintOutline(canvas, leg, false, Role::Preview);
  const double length = (leg[1] - leg[0]).norm();
  if (length > 0.0)
    paintNote(canvas, canvas.toDevice(*pointer_) + QPointF(0.0, 22.0), metresText(length));
}

}  // namespace handmap
