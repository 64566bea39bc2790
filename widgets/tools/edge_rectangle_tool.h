// Draw a rectangular building at any angle: one edge, then how deep it is.
#pragma once

#include "widgets/tools/drawing_tool.h"

namespace handmap {

class EdgeRectangleTool : public DrawingTool {
  Q_OBJECT
 public:
  using DrawingTool::DrawingTool;

  ToolId id() const override { return ToolId::EdgeRectangle; }
  QString hint() const override;
  void paint(ToolPaint& canvas) const override;

 protected:
  std::size_t pointCount() const override { return 3; }
  std::vector<Number> numbers() const override;
  Vec2 constrained(const Vec2& pointer) const override;
  bool mayPlace(const Vec2& point) const override;
  void complete() override;

 private:
  Rectangle box(const Vec2& third) const;  ///< both ends of the edge are placed
};

}  // namespace handmap
