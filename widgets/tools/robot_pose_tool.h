// Say where the robot is at the moment that is shown, and which way it looks.
#pragma once

#include "widgets/tools/start_tool.h"

namespace handmap {

class RobotPoseTool : public StartTool {
  Q_OBJECT
 public:
  using StartTool::StartTool;

  ToolId id() const override { return ToolId::RobotPose; }
  QString hint() const override;
  const MapChange* preview() const override { return nullptr; }
  void paint(ToolPaint& canvas) const override;

 Q_SIGNALS:
  void given(const handmap::Pose2& pose);

 protected:
  void done(const Pose2& pose) override { Q_EMIT given(pose); }
};

}  // namespace handmap
