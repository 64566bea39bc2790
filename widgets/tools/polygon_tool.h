// Draw a building of any simple shape, corner by corner.
#pragma once

#include "widgets/tools/drawing_tool.h"

namespace handmap {

class PolygonTool : public DrawingTool {
  Q_OBJECT
 public:
  using DrawingTool::DrawingTool;

  ToolId id() const override { return ToolId::Corners; }
  QString hint() const override;
  bool canFinish() const override { return placed().size() >= 3; }
  void finish() override;
  void paint(ToolPaint& canvas) const override;

 protected:
  std::size_t pointCount() const override { return 0; }
  bool mayPlace(const Vec2& point) const override;
  bool closesAt(const Vec2& point) const override;
  void complete() override {}
};

}  // namespace handmap
