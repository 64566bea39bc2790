#include "widgets/tools/robot_pose_tool.h"

#include <QPainter>

#include "widgets/style/colours.h"

namespace handmap {

QString RobotPoseTool::hint() const {
  if (!placedPose()) return tr("Press where the robot is now, drag to where it looks");
  return StartTool::hint();
}

void RobotPoseTool::paint(ToolPaint& canvas) const {
  if (!placedPose()) return;
  constexpr double kLengthPx = 34.0;
  constexpr double kHeadPx = 9.0;
  const double m = canvas.metresPerPixel();
  const QPointF at = canvas.toDevice(placedPose()->position());
  const QPointF tip = canvas.toDevice(placedPose()->toOuter({kLengthPx * m, 0.0}));
  const QPointF left =
      canvas.toDevice(placedPose()->toOuter({(kLengthPx - kHeadPx) * m, kHeadPx * m}));
  const QPointF right =
      canvas.toDevice(placedPose()->toOuter({(kLengthPx - kHeadPx) * m, -kHeadPx * m}));
  canvas.painter.setPen(canvas.colours.pen(Role::Preview));
  canvas.painter.setBrush(Qt::NoBrush);
  canvas.painter.drawEllipse(at, 7.0, 7.0);
  canvas.painter.drawLine(at, tip);
  canvas.painter.drawPolyline(QPolygonF{left, tip, right});
  StartTool::paint(canvas);
}

}  // namespace handmap
