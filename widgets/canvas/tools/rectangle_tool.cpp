#include "widgets/canvas/tools/rectangle_tool.h"

#include "widgets/canvas/tools/building_handles.h"
#include "widgets/canvas/tools/tool_painting.h"

namespace handmap {

namespace {

constexpr double kMinDragPx = 3.0;

Rectangle between(const Vec2& from, const ToolEvent& event) {
  Vec2 way = event.snapped - from;
  if (event.modifiers & Qt::ShiftModifier) {
    const double side = way.cwiseAbs().maxCoeff();
    way = {std::copysign(side, way.x()), std::copysign(side, way.y())};
  }
  if (event.modifiers & Qt::AltModifier)
    return {from, 2.0 * std::abs(way.x()), 2.0 * std::abs(way.y()), 0.0};
  return {from + way / 2.0, std::abs(way.x()), std::abs(way.y()), 0.0};
}

}  // namespace

QString RectangleTool::hint() const {
  if (!from_) return tr("Drag from corner to corner to draw a building");
  return tr("Release to finish · Shift: square · Alt: from the centre · Esc: cancel");
}

bool RectangleTool::cancel() {
  const bool was_busy = from_.has_value();
  from_.reset();
  drawn_.reset();
  if (was_busy) Q_EMIT changed();
  return was_busy;
}

void RectangleTool::press(const ToolEvent& event) {
  from_ = event.snapped;
  drawn_.reset();
  Q_EMIT changed();
}

void RectangleTool::move(const ToolEvent& event) {
  if (!from_) return;
  const Rectangle box = between(*from_, event);
  const double least = std::max(kMinSize, kMinDragPx * event.metres_per_pixel);
  drawn_.reset();
  if (box.width >= least && box.depth >= least) drawn_ = box;
  Q_EMIT changed();
}

void RectangleTool::release(const ToolEvent& event) {
  move(event);
  const std::optional<Rectangle> box = drawn_;
  cancel();
  if (!box) return;
  Building building;
  building.shape = *box;
  document().setSelection({document().addBuilding(std::move(building))});
}

void RectangleTool::paint(ToolPaint& canvas) const {
  if (!drawn_) return;
  paintOutline(canvas, drawn_->corners(), true, Role::Preview);
  paintSizes(canvas, *drawn_);
}

}  // namespace handmap
