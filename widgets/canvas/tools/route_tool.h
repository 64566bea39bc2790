// Draw the way that the robot shall take, point by point. Every point is a change of its own, so
// that undo and Backspace both take back the last.
#pragma once

#include "widgets/canvas/tool.h"

namespace handmap {

class RouteTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  ToolId id() const override { return ToolId::Route; }
  QString hint() const override;
  void activate() override { pointer_.reset(); }
  void press(const ToolEvent& event) override;
  void move(const ToolEvent& event) override;
  void doubleClick(const ToolEvent&) override {}
  bool key(const ToolKey& key) override;
  void paint(ToolPaint& canvas) const override;

 private:
  std::optional<Vec2> pointer_;
};

}  // namespace handmap
