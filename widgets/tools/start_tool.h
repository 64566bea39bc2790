// Say where the robot starts and which way it looks.
#pragma once

#include "widgets/tools/drawing_tool.h"

namespace handmap {

class StartTool : public DrawingTool {
  Q_OBJECT
 public:
  using DrawingTool::DrawingTool;

  ToolId id() const override { return ToolId::Start; }
  QString hint() const override;
  const MapChange* preview() const override;
  /// A robot stands free of walls, and looks anywhere.
  std::optional<SnapContext> snapContext() const override { return std::nullopt; }
  void paint(ToolPaint& canvas) const override;

 protected:
  std::size_t pointCount() const override { return 2; }
  std::vector<Number> numbers() const override;
  Vec2 constrained(const Vec2& pointer) const override;
  bool isCompleteByClick() const override { return true; }
  void complete() override;
  virtual void done(const Pose2& pose);
  /// What is being placed.
  std::optional<Pose2> placedPose() const;

 private:
  mutable MapChange preview_;
};

}  // namespace handmap
