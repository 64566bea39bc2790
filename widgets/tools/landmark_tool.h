// Mark places by name.
#pragma once

#include "widgets/tools/drawing_tool.h"

namespace handmap {

class LandmarkTool : public DrawingTool {
  Q_OBJECT
 public:
  using DrawingTool::DrawingTool;

  ToolId id() const override { return ToolId::Landmark; }
  QString hint() const override { return tr("Click to mark a place, then type its name"); }

 protected:
  std::size_t pointCount() const override { return 1; }
  void complete() override {
    Landmark landmark;
    landmark.position = placed().front();
    cancel();
    const QString id = document().addLandmark(std::move(landmark));
    document().setSelection({id});
    Q_EMIT created(id);
  }
};

}  // namespace handmap
