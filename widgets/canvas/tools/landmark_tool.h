// Mark places by name.
#pragma once

#include "widgets/canvas/tool.h"

namespace handmap {

class LandmarkTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  ToolId id() const override { return ToolId::Landmark; }
  QString hint() const override {
    return tr("Click to mark a place · its name is set under Properties");
  }
  void press(const ToolEvent& event) override {
    Landmark landmark;
    landmark.position = event.snapped;
    document().setSelection({document().addLandmark(std::move(landmark))});
  }
};

}  // namespace handmap
