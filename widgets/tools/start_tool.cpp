#include "widgets/tools/start_tool.h"

#include "widgets/canvas/building_handles.h"
#include "widgets/tools/tool_painting.h"

namespace handmap {

namespace {

constexpr double kStartDragPx = 8.0;

}  // namespace

QString StartTool::hint() const {
  if (placed().empty()) return tr("Press where the robot starts, drag to where it looks");
  return tr("Release to finish, or type the heading · Shift: steps of 15° · Esc: cancel");
}

std::optional<Pose2> StartTool::placedPose() const {
  if (placed().empty()) return std::nullopt;
  const Vec2& at = placed().front();
  double heading = document().map().start.value_or(Pose2{}).heading;
  if (const auto typed_heading = typed().value(0)) {
    heading = normalizedAngle(toRadians(*typed_heading));
  } else if (const Vec2 offset = pointer() - at; offset.norm() >= kStartDragPx * metresPerPixel()) {
    const bool held = modifiers() & (Qt::ShiftModifier | Qt::ControlModifier);
    heading = roundedHeading(std::atan2(offset.y(), offset.x()), held ? 15.0 : 0.5);
  }
  return Pose2{at.x(), at.y(), heading};
}

std::vector<DrawingTool::Number> StartTool::numbers() const {
  if (placed().empty()) return DrawingTool::numbers();
  return {{tr("Heading"), toDegrees(placedPose()->heading), true}};
}

Vec2 StartTool::constrained(const Vec2& pointer) const {
  return placed().empty() ? DrawingTool::constrained(pointer) : pointer;
}

void StartTool::complete() {
  const Pose2 pose = *placedPose();
  cancel();
  done(pose);
}

void StartTool::done(const Pose2& pose) {
  document().setStart(pose);
  document().setSelection({kStartKey});
  Q_EMIT changed();
}

const MapChange* StartTool::preview() const {
  if (placed().empty()) return nullptr;
  preview_.start = placedPose();
  return &preview_;
}

void StartTool::paint(ToolPaint& canvas) const {
  if (!placed().empty() && typed().isEmpty()) {
    const QPointF at = canvas.toDevice(placed().front());
    paintNote(canvas, at + QPointF(0.0, 26.0), degreesText(placedPose()->heading));
    if (!isByKeys()) return;
  }
  DrawingTool::paint(canvas);
}

}  // namespace handmap
