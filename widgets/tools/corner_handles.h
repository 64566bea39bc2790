// Corners of a polygon or of the route as handles: to drag, to add between two, to take away.
#pragma once

#include <optional>

#include "widgets/canvas/tool.h"

namespace handmap {

/// The corners that are shown as handles: of the one selected polygon, or of the selected route.
struct CornerLine {
  std::vector<Vec2> corners;
  bool closed = false;
  std::size_t edgeCount() const { return corners.size() - (closed ? 0 : 1); }
};
std::optional<CornerLine> selectedCorners(const MapDocument& document);

struct CornerHandle {
  std::size_t corner = 0;
  bool between = false;  ///< in the middle of the edge behind that corner: it makes a new one
};
/// Where there is room for a handle in the middle of an edge.
bool hasRoomBetween(const CornerLine& line, std::size_t edge, double metres_per_pixel);
Vec2 positionOf(const CornerLine& line, const CornerHandle& handle);
std::optional<CornerHandle> cornerHandleAt(const CornerLine& line, const ToolEvent& event);

// --- What the selected object becomes; nothing where its outline would cross itself.
std::optional<MapChange> withCornerMoved(const MapDocument& document, const CornerHandle& handle,
                                         const Vec2& to);
std::optional<MapChange> withCornerRemoved(const MapDocument& document, std::size_t corner);
/// On the edge of the one selected object that is nearest within `reach`; a rectangle becomes a
/// polygon. `corner` is the number of the new one.
std::optional<MapChange> withCornerAdded(const MapDocument& document, const Vec2& at, double reach,
                                         std::size_t& corner);

void paintCorners(ToolPaint& canvas, const CornerLine& line, std::optional<std::size_t> chosen);

}  // namespace handmap
