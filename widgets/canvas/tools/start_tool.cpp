#include "widgets/canvas/tools/start_tool.h"

#include "widgets/canvas/tools/building_handles.h"
#include "widgets/canvas/tools/tool_painting.h"

namespace handmap {

namespace {

constexpr double kDragPx = 8.0;

}  // namespace

QString StartTool::hint() const {
  if (!preview_.start) return tr("Press where the robot starts, drag to where it looks");
  return tr("Release to finish · Shift: steps of 15° · Esc: cancel");
}

bool StartTool::cancel() {
  const bool was_busy = preview_.start.has_value();
  preview_.start.reset();
  if (was_busy) Q_EMIT changed();
  return was_busy;
}

void StartTool::press(const ToolEvent& event) {
  const double heading = document().map().start.value_or(Pose2{}).heading;
  preview_.start = Pose2{event.snapped.x(), event.snapped.y(), heading};
  Q_EMIT changed();
}

void StartTool::move(const ToolEvent& event) {
  if (!preview_.start) return;
  const Vec2 ahead = event.position - preview_.start->position();
  if (ahead.norm() < kDragPx * event.metres_per_pixel) return;
  const bool held = event.modifiers & (Qt::ShiftModifier | Qt::ControlModifier);
  preview_.start->heading = roundedHeading(std::atan2(ahead.y(), ahead.x()), held ? 15.0 : 0.5);
  Q_EMIT changed();
}

void StartTool::release(const ToolEvent& event) {
  if (!preview_.start) return;
  move(event);
  const std::optional<Pose2> start = preview_.start;
  cancel();
  done(*start);
}

void StartTool::done(const Pose2& pose) {
  document().setStart(pose);
  document().setSelection({kStartKey});
}

void StartTool::paint(ToolPaint& canvas) const {
  if (!preview_.start) return;
  const QPointF at = canvas.toDevice(preview_.start->position());
  paintNote(canvas, at + QPointF(0.0, 26.0), degreesText(preview_.start->heading));
}

}  // namespace handmap
