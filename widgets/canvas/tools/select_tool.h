// Select, move, resize and turn.
#pragma once

#include "widgets/canvas/tools/drags.h"

namespace handmap {

class SelectTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  ToolId id() const override { return ToolId::Select; }
  QString hint() const override;
  Qt::CursorShape cursor() const override { return cursor_; }

  bool cancel() override;
  void press(const ToolEvent& event) override;
  void move(const ToolEvent& event) override;
  void release(const ToolEvent& event) override;
  bool key(const ToolKey& key) override;
  const MapChange* preview() const override { return preview_ ? &*preview_ : nullptr; }
  void paint(ToolPaint& canvas) const override;

 private:
  void selectPressed(const QString& key, Qt::KeyboardModifiers modifiers);
  void updateCursor(const ToolEvent& event);
  void paintReadout(ToolPaint& canvas) const;

  std::optional<Drag> drag_;
  std::optional<MapChange> preview_;
  std::optional<ToolEvent> pressed_;
  std::optional<Vec2> rubber_end_;
  QString clicked_;  ///< an object of a larger selection: a click without a drag leaves only it
  Qt::CursorShape cursor_ = Qt::ArrowCursor;
};

}  // namespace handmap
