// Measure: lengths, angles and the area of what is clicked around. Changes nothing.
#pragma once

#include "widgets/tools/drawing_tool.h"

namespace handmap {

class MeasureTool : public DrawingTool {
  Q_OBJECT
 public:
  using DrawingTool::DrawingTool;

  ToolId id() const override { return ToolId::Measure; }
  QString hint() const override;
  bool cancel() override;
  bool canFinish() const override { return placed().size() >= 2; }
  void finish() override;
  void press(const ToolEvent& event) override;
  void paint(ToolPaint& canvas) const override;

 protected:
  std::size_t pointCount() const override { return 0; }
  void complete() override {}

 private:
  std::vector<Vec2> measured_;  ///< what stays to be read until the next point
};

}  // namespace handmap
