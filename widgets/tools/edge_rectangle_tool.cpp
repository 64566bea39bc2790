#include "widgets/tools/edge_rectangle_tool.h"

#include "core/map/map_limits.h"
#include "widgets/canvas/building_handles.h"
#include "widgets/tools/tool_painting.h"

namespace handmap {

QString EdgeRectangleTool::hint() const {
  if (placed().empty()) return tr("Drag or click along one wall of the building");
  if (placed().size() == 1) return tr("The other end of the wall · or type its length and angle");
  return tr("How deep is it? Click, or type the depth · Backspace: one back · Esc: cancel");
}

Rectangle EdgeRectangleTool::box(const Vec2& third) const {
  const Vec2 edge = placed()[1] - placed()[0];
  const Vec2 along = edge.normalized();
  const double depth = (third - placed()[0]).dot(perpendicular(along));
  return {placed()[0] + edge / 2.0 + perpendicular(along) * depth / 2.0, edge.norm(),
          std::abs(depth), std::atan2(along.y(), along.x())};
}

std::vector<DrawingTool::Number> EdgeRectangleTool::numbers() const {
  if (placed().size() < 2) return DrawingTool::numbers();
  return {{tr("Depth"), box(next()).depth}};
}

Vec2 EdgeRectangleTool::constrained(const Vec2& pointer) const {
  if (placed().size() < 2) return DrawingTool::constrained(pointer);
  const Vec2 across = perpendicular((placed()[1] - placed()[0]).normalized());
  const double side = (pointer - placed()[0]).dot(across);
  const auto depth = typed().value(0);
  if (!depth) return pointer;
  return placed()[1] + across * std::copysign(std::min(*depth, kMaxSize), side);
}

bool EdgeRectangleTool::mayPlace(const Vec2& point) const {
  if (placed().empty()) return true;
  if (placed().size() == 1) return (point - placed()[0]).norm() >= kMinSize;
  return box(point).depth >= kMinSize;
}

void EdgeRectangleTool::complete() {
  Building building;
  building.shape = box(placed()[2]);
  cancel();
  const QString id = document().addBuilding(std::move(building));
  document().setSelection({id});
  Q_EMIT created(id);
}

void EdgeRectangleTool::paint(ToolPaint& canvas) const {
  const Role role = isRefused() ? Role::Problem : Role::Preview;
  if (placed().size() == 1) paintOutline(canvas, withNext(), false, role);
  if (placed().size() == 2) paintOutline(canvas, box(next()).corners(), true, role);
  for (const Vec2& point : placed()) paintHandle(canvas, point);
  DrawingTool::paint(canvas);
}

}  // namespace handmap
