// Draw a rectangular building from corner to corner.
#pragma once

#include "widgets/tools/drawing_tool.h"

namespace handmap {

class RectangleTool : public DrawingTool {
  Q_OBJECT
 public:
  using DrawingTool::DrawingTool;

  ToolId id() const override { return ToolId::Rectangle; }
  QString hint() const override;
  void paint(ToolPaint& canvas) const override;

 protected:
  std::size_t pointCount() const override { return 2; }
  std::vector<Number> numbers() const override;
  Vec2 constrained(const Vec2& pointer) const override;
  bool mayPlace(const Vec2& point) const override;
  void complete() override;

 private:
  Rectangle between(const Vec2& from, const Vec2& to) const;
};

}  // namespace handmap
