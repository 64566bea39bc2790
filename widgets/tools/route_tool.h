// Draw the way that the robot shall take, point by point. Every point is a change of its own, so
// that undo and Backspace both take back the last.
#pragma once

#include "widgets/tools/drawing_tool.h"

namespace handmap {

class RouteTool : public DrawingTool {
  Q_OBJECT
 public:
  using DrawingTool::DrawingTool;

  ToolId id() const override { return ToolId::Route; }
  QString hint() const override;
  bool cancel() override;
  bool isBusy() const override { return !typed().isEmpty(); }
  bool canFinish() const override { return !placed().empty(); }
  void finish() override { Q_EMIT finished(); }
  void paint(ToolPaint& canvas) const override;

 protected:
  std::size_t pointCount() const override { return 0; }
  void complete() override {}
  const std::vector<Vec2>& placed() const override { return document().map().route; }
  void append(const Vec2& point) override;
  void removeLast() override;
};

}  // namespace handmap
