// Say where the robot starts and which way it looks.
#pragma once

#include "widgets/canvas/tool.h"

namespace handmap {

class StartTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  ToolId id() const override { return ToolId::Start; }
  QString hint() const override;
  bool cancel() override;
  void press(const ToolEvent& event) override;
  void move(const ToolEvent& event) override;
  void release(const ToolEvent& event) override;
  const MapChange* preview() const override { return preview_.start ? &preview_ : nullptr; }
  void paint(ToolPaint& canvas) const override;

 protected:
  virtual void done(const Pose2& pose);
  /// What is being placed.
  const std::optional<Pose2>& placed() const { return preview_.start; }

 private:
  MapChange preview_;
};

}  // namespace handmap
