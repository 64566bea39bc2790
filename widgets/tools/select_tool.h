// Select, move, resize and turn; drag, add and take away corners.
#pragma once

#include "widgets/tools/drags.h"

namespace handmap {

class SelectTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  ToolId id() const override { return ToolId::Select; }
  QString hint() const override;
  Qt::CursorShape cursor() const override { return cursor_; }

  bool cancel() override;
  void interrupt() override { dropPress(); }
  void press(const ToolEvent& event) override;
  void move(const ToolEvent& event) override;
  void release(const ToolEvent& event) override;
  void doubleClick(const ToolEvent& event) override;
  bool key(const ToolKey& key) override;
  std::optional<SnapContext> snapContext() const override;
  const MapChange* preview() const override { return preview_ ? &*preview_ : nullptr; }
  void paint(ToolPaint& canvas) const override;

  /// The corner of the selected polygon or route that keys act upon.
  std::optional<std::size_t> chosenCorner() const;
  /// An edge or a corner of what is selected, under the pointer.
  bool chooseAt(const ToolEvent& event) override;
  bool removeChosen() override;
  bool isOnEdge(const ToolEvent& event) const;
  bool addCornerAt(const Vec2& position, double reach);
  bool addCornerBehindChosen();  ///< in the middle of the edge behind it
  bool removeChosenCorner();     ///< false when none is chosen or the rest would be no outline

 Q_SIGNALS:
  void renameRequested(const QString& key);

 private:
  bool dropPress();
  void selectPressed(const QString& key, Qt::KeyboardModifiers modifiers);
  void chooseCorner(std::optional<std::size_t> corner);
  bool stepThroughCorners(int by);
  bool stepThroughObjects(int by);
  bool nudge(const Vec2& step);
  void updateCursor(const ToolEvent& event);
  void paintReadout(ToolPaint& canvas) const;

  std::optional<Drag> drag_;
  std::optional<MapChange> preview_;
  bool refused_ = false;  ///< the pointer is where the outline would cross itself
  std::optional<ToolEvent> pressed_;
  std::optional<Vec2> rubber_end_;
  QString clicked_;  ///< an object of a larger selection: a click without a drag leaves only it
  std::optional<std::size_t> corner_;
  QString corner_of_;  ///< the object that corner_ is of
  Qt::CursorShape cursor_ = Qt::ArrowCursor;
};

}  // namespace handmap
