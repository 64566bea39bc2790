#include "widgets/tools/route_tool.h"

#include "widgets/tools/tool_painting.h"

namespace handmap {

QString RouteTool::hint() const {
  if (placed().empty()) return tr("Click the points of the robot's way");
  return tr("Click to lengthen the route · Backspace: one point back · Enter or Esc: done");
}

/// What is placed is in the drawing and stays.
bool RouteTool::cancel() {
  const bool was_typing = !typed().isEmpty();
  DrawingTool::cancel();
  return was_typing;
}

void RouteTool::append(const Vec2& point) {
  std::vector<Vec2> route = placed();
  route.push_back(point);
  document().setRoute(std::move(route));
  document().setSelection({kRouteKey});
}

void RouteTool::removeLast() {
  std::vector<Vec2> route = placed();
  route.pop_back();
  document().setRoute(std::move(route));
}

void RouteTool::paint(ToolPaint& canvas) const {
  if (placed().empty() || !isPointerKnown()) return DrawingTool::paint(canvas);
  const Vec2 leg[] = {placed().back(), next()};
  paintOutline(canvas, leg, false, Role::Preview);
  const double length = (leg[1] - leg[0]).norm();
  if (length > 0.0 && !isBusy() && !isByKeys())
    paintNote(canvas, canvas.toDevice(next()) + QPointF(0.0, 22.0), metresText(length));
  DrawingTool::paint(canvas);
}

}  // namespace handmap
