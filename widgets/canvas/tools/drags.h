// What can be dragged with the select tool.
#pragma once

#include <functional>

#include "widgets/canvas/tool.h"

namespace handmap {

enum class Readout { None, Size, Heading, Position };

struct Drag {
  /// What the objects become when the pointer is there.
  std::function<MapChange(const ToolEvent&)> change;
  QString text;  ///< of the undo step
  Readout readout = Readout::None;
};

/// The selected building, when nothing else is selected.
const Building* onlyBuilding(const MapDocument& document);
/// Where the handle of the start's heading lies.
Vec2 startHandle(const Pose2& start, double metres_per_pixel);

/// A handle of what is selected, when there is one under the pointer.
std::optional<Drag> handleDrag(const MapDocument& document, const ToolEvent& press);
/// All that is selected.
Drag moveDrag(const MapDocument& document, const ToolEvent& press);

}  // namespace handmap
