// What can be dragged with the select tool.
#pragma once

#include <functional>

#include "widgets/canvas/tool.h"

namespace handmap {

enum class Readout { None, Size, Heading, Position };

struct Drag {
  /// What the objects become when the pointer is there; nothing where that cannot be.
  std::function<std::optional<MapChange>(const ToolEvent&)> change;
  QString text;  ///< of the undo step
  Readout readout = Readout::None;
  SnapContext snap = {};
  std::optional<std::size_t> corner = {};  ///< the one that is dragged
};

/// The selected building, when nothing else is selected.
const Building* onlyBuilding(const MapDocument& document);
/// The box on which the handles of a building lie: its own, or one around a polygon, whose corners
/// have handles too.
Rectangle handleFrame(const Building& building, double metres_per_pixel);
/// Where the handle of the start's heading lies.
Vec2 startHandle(const Pose2& start, double metres_per_pixel);

/// A handle of what is selected, when there is one under the pointer.
std::optional<Drag> handleDrag(const MapDocument& document, const ToolEvent& press);
/// All that is selected and not locked; nothing when that is nothing.
std::optional<Drag> moveDrag(const MapDocument& document, const ToolEvent& press);

}  // namespace handmap
