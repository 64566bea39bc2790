// Erase what a stroke touches, in one step.
#pragma once

#include <QSet>

#include "widgets/canvas/tool.h"

namespace handmap {

class EraserTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  ToolId id() const override { return ToolId::Eraser; }
  QString hint() const override;
  bool cancel() override;
  void press(const ToolEvent& event) override;
  void move(const ToolEvent& event) override;
  void release(const ToolEvent& event) override;
  bool key(const ToolKey& key) override;
  bool isBusy() const override { return pressed_; }
  std::optional<Vec2> keyboardCursor() const override { return cursor_; }
  void paint(ToolPaint& canvas) const override;

 private:
  void touch(const ToolEvent& event);

  bool pressed_ = false;
  Vec2 last_ = Vec2::Zero();
  QStringList touched_;
  std::optional<Vec2> cursor_;  ///< of the keyboard
};

}  // namespace handmap
