// Draw a building of any simple shape, corner by corner.
#pragma once

#include "widgets/canvas/tool.h"

namespace handmap {

class PolygonTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  ToolId id() const override { return ToolId::Corners; }
  QString hint() const override;
  bool cancel() override;
  void press(const ToolEvent& event) override;
  void move(const ToolEvent& event) override;
  void doubleClick(const ToolEvent& event) override;
  bool key(const ToolKey& key) override;
  void paint(ToolPaint& canvas) const override;

 private:
  bool isOnFirst(const ToolEvent& event) const;
  void close();

  Polygon corners_;
  Vec2 pointer_ = Vec2::Zero();
  bool closing_ = false;  ///< the pointer is on the first corner
  bool refused_ = false;  ///< the last corner, or closing, would make the outline cross itself
};

}  // namespace handmap
