// Draw a rectangular building from corner to corner.
#pragma once

#include "widgets/canvas/tool.h"

namespace handmap {

class RectangleTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  ToolId id() const override { return ToolId::Rectangle; }
  QString hint() const override;
  bool cancel() override;
  void press(const ToolEvent& event) override;
  void move(const ToolEvent& event) override;
  void release(const ToolEvent& event) override;
  void paint(ToolPaint& canvas) const override;

 private:
  std::optional<Vec2> from_;
  std::optional<Rectangle> drawn_;  ///< large enough to be a building
};

}  // namespace handmap
