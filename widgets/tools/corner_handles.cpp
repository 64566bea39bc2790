#include "widgets/tools/corner_handles.h"

#include <QPainter>
#include <algorithm>

#include "core/map/map_limits.h"
#include "core/sketching/corners.h"
#include "widgets/canvas/building_handles.h"
#include "widgets/tools/drags.h"
#include "widgets/tools/tool_painting.h"

namespace handmap {

namespace {

constexpr double kRoomPx = 36.0;

MapChange withOutline(const Building& building, Polygon outline) {
  Building changed = building;
  changed.shape = std::move(outline);
  return {.buildings = {std::move(changed)}};
}

std::optional<MapChange> withOutline(const Building& building, std::optional<Polygon> outline) {
  if (!outline || outline->size() > kMaxPolygonVertices) return std::nullopt;
  return withOutline(building, std::move(*outline));
}

}  // namespace

std::optional<CornerLine> selectedCorners(const MapDocument& document) {
  if (document.selection() == QStringList{kRouteKey})
    return CornerLine{document.map().route, false};
  const Building* building = onlyBuilding(document);
  const auto* outline = building ? std::get_if<Polygon>(&building->shape) : nullptr;
  if (!outline || building->flags.locked) return std::nullopt;
  return CornerLine{*outline, true};
}

Vec2 positionOf(const CornerLine& line, const CornerHandle& handle) {
  if (!handle.between) return line.corners[handle.corner];
  const Segment edge = edgeOf(line.corners, handle.corner);
  return (edge.a + edge.b) / 2.0;
}

bool hasRoomBetween(const CornerLine& line, std::size_t edge, double metres_per_pixel) {
  return edgeOf(line.corners, edge).length() >= kRoomPx * metres_per_pixel;
}

std::optional<CornerHandle> cornerHandleAt(const CornerLine& line, const ToolEvent& event) {
  const double reach = event.reach(kHandleReachPx);
  if (const auto corner = cornerNear(line.corners, event.position, reach))
    return CornerHandle{*corner};
  for (std::size_t i = 0; i < line.edgeCount(); ++i) {
    const CornerHandle handle{i, true};
    if (hasRoomBetween(line, i, event.metres_per_pixel) &&
        (positionOf(line, handle) - event.position).norm() <= reach)
      return handle;
  }
  return std::nullopt;
}

std::optional<MapChange> withCornerMoved(const MapDocument& document, const CornerHandle& handle,
                                         const Vec2& to) {
  if (const Building* building = onlyBuilding(document)) {
    const Polygon outline = building->footprint();
    if (handle.corner >= outline.size()) return std::nullopt;
    return withOutline(*building, handle.between ? withCornerOn(outline, handle.corner, to)
                                                 : withCornerAt(outline, handle.corner, to));
  }
  std::vector<Vec2> route = document.map().route;
  if (handle.corner >= route.size()) return std::nullopt;
  if (handle.between)
    route.insert(route.begin() + static_cast<std::ptrdiff_t>(handle.corner) + 1, to);
  else
    route[handle.corner] = to;
  return MapChange{.route = std::move(route)};
}

std::optional<MapChange> withCornerRemoved(const MapDocument& document, std::size_t corner) {
  if (const Building* building = onlyBuilding(document)) {
    const Polygon outline = building->footprint();
    if (corner >= outline.size()) return std::nullopt;
    return withOutline(*building, withoutCorner(outline, corner));
  }
  std::vector<Vec2> route = document.map().route;
  if (corner >= route.size()) return std::nullopt;
  route.erase(route.begin() + static_cast<std::ptrdiff_t>(corner));
  return MapChange{.route = std::move(route)};
}

std::optional<MapChange> withCornerAdded(const MapDocument& document, const Vec2& at, double reach,
                                         std::size_t& corner) {
  CornerLine line;
  const Building* building = onlyBuilding(document);
  if (building && !building->flags.locked)
    line = {building->footprint(), true};
  else if (document.selection() == QStringList{kRouteKey})
    line = {document.map().route, false};
  else
    return std::nullopt;
  const auto edge = edgeNear(line.corners, at, reach, line.edgeCount());
  if (!edge) return std::nullopt;
  corner = *edge + 1;
  const Segment on = edgeOf(line.corners, *edge);
  const Vec2 along = (on.b - on.a) / std::max(on.length(), 1e-9);
  return withCornerMoved(document, {*edge, true},
                         on.a + along * std::round((at - on.a).dot(along) * 100.0) / 100.0);
}

void paintCorners(ToolPaint& canvas, const CornerLine& line, std::optional<std::size_t> chosen) {
  for (std::size_t i = 0; i < line.edgeCount(); ++i) {
    if (!hasRoomBetween(line, i, canvas.metresPerPixel())) continue;
    const QPointF at = canvas.toDevice(positionOf(line, {i, true}));
    canvas.painter.setPen(QPen(canvas.colours[Role::Selection], 1.0));
    canvas.painter.setBrush(canvas.colours[Role::Background]);
    canvas.painter.drawEllipse(at, 3.0, 3.0);
  }
  for (std::size_t i = 0; i < line.corners.size(); ++i) {
    paintHandle(canvas, line.corners[i]);
    if (chosen != i) continue;
    canvas.painter.setPen(QPen(canvas.colours[Role::Selection], 2.0));
    canvas.painter.setBrush(canvas.colours[Role::Selection]);
    canvas.painter.drawEllipse(canvas.toDevice(line.corners[i]), 6.0, 6.0);
  }
}

}  // namespace handmap
