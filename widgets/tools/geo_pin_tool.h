// Click two places of the drawing whose longitude and latitude are known.
#pragma once

#include <vector>

#include "core/map/georeference_fit.h"
#include "widgets/canvas/tool.h"

namespace handmap {

class GeoPinTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  ToolId id() const override { return ToolId::GeoPin; }
  QString hint() const override;
  bool cancel() override;
  void press(const ToolEvent& event) override;
  bool isBusy() const override { return !pins_.empty(); }
  bool canTakeBack() const override { return !pins_.empty(); }
  void takeBack() override;
  std::optional<SnapContext> snapContext() const override { return SnapContext{}; }
  void paint(ToolPaint& canvas) const override;

  /// Of a place that was clicked. Two of them end the tool's work.
  void pin(const GeoPin& pin);

 Q_SIGNALS:
  void placed(const handmap::Vec2& in_map);
  void complete(const handmap::GeoPin& first, const handmap::GeoPin& second);

 private:
  std::vector<GeoPin> pins_;
};

}  // namespace handmap
