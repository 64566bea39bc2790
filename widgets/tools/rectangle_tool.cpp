#include "widgets/tools/rectangle_tool.h"

#include "core/map/map_limits.h"
#include "widgets/canvas/building_handles.h"
#include "widgets/tools/tool_painting.h"

namespace handmap {

namespace {

constexpr double kMinDragPx = 3.0;

}  // namespace

QString RectangleTool::hint() const {
  if (placed().empty())
    return tr("Drag from corner to corner, or click both · arrow keys and Enter do it too");
  return tr(
      "The opposite corner, or type: 40 Tab 15 Enter · Shift: square · Ctrl: from the centre "
      "· Esc: cancel");
}

Rectangle RectangleTool::between(const Vec2& from, const Vec2& to) const {
  const Vec2 offset = to - from;
  if (modifiers() & Qt::ControlModifier)
    return {from, 2.0 * std::abs(offset.x()), 2.0 * std::abs(offset.y()), 0.0};
  return {from + offset / 2.0, std::abs(offset.x()), std::abs(offset.y()), 0.0};
}

std::vector<DrawingTool::Number> RectangleTool::numbers() const {
  if (placed().empty()) return DrawingTool::numbers();
  const Rectangle box = between(placed().front(), next());
  return {{tr("Width"), box.width}, {tr("Depth"), box.depth}};
}

Vec2 RectangleTool::constrained(const Vec2& pointer) const {
  if (placed().empty()) return DrawingTool::constrained(pointer);
  const Vec2& from = placed().front();
  Vec2 offset = pointer - from;
  if (modifiers() & Qt::ShiftModifier) {
    const double side = offset.cwiseAbs().maxCoeff();
    offset = {std::copysign(side, offset.x()), std::copysign(side, offset.y())};
  }
  const double share = modifiers() & Qt::ControlModifier ? 0.5 : 1.0;
  for (const int axis : {0, 1}) {
    const auto typed_size = typed().value(static_cast<std::size_t>(axis));
    if (typed_size)
      offset[axis] = std::copysign(share * std::min(*typed_size, kMaxSize), offset[axis]);
  }
  return from + offset;
}

bool RectangleTool::mayPlace(const Vec2& point) const {
  if (placed().empty()) return true;
  const Rectangle box = between(placed().front(), point);
  const bool exact = !typed().isEmpty() || isByKeys();
  const double least = exact ? kMinSize : std::max(kMinSize, kMinDragPx * metresPerPixel());
  return box.width >= least && box.depth >= least;
}

void RectangleTool::complete() {
  Building building;
  building.shape = between(placed()[0], placed()[1]);
  cancel();
  const QString id = document().addBuilding(std::move(building));
  document().setSelection({id});
  Q_EMIT created(id);
}

void RectangleTool::paint(ToolPaint& canvas) const {
  if (!placed().empty() && next() != placed().front())
    paintOutline(canvas, between(placed().front(), next()).corners(), true,
                 isRefused() ? Role::Problem : Role::Preview);
  DrawingTool::paint(canvas);
}

}  // namespace handmap
