#include "widgets/tools/polygon_tool.h"

#include <algorithm>

#include "core/map/map_limits.h"
#include "widgets/tools/tool_painting.h"

namespace handmap {

namespace {

constexpr double kCloseReachPx = 9.0;

/// Which side of the segment's line the point lies on: -1, 0 or 1.
int sideOf(const Segment& segment, const Vec2& point) {
  const double side = cross(segment.b - segment.a, point - segment.a);
  return (side > 0.0) - (side < 0.0);
}

bool meet(const Segment& a, const Segment& b) {
  if (sideOf(a, b.a) * sideOf(a, b.b) < 0 && sideOf(b, a.a) * sideOf(b, a.b) < 0) return true;
  return distanceTo(a, b.a) == 0.0 || distanceTo(a, b.b) == 0.0 || distanceTo(b, a.a) == 0.0 ||
         distanceTo(b, a.b) == 0.0;
}

/// Whether the open line of corners may go on to `next` without meeting itself.
bool mayGoOn(const Polygon& corners, const Vec2& next) {
  if (corners.empty()) return true;
  if (corners.back() == next) return false;
  const Segment edge{corners.back(), next};
  for (std::size_t i = 0; i + 2 < corners.size(); ++i)
    if (meet({corners[i], corners[i + 1]}, edge)) return false;
  // The edge before shares a corner; it must not be walked back on.
  if (corners.size() < 2) return true;
  const Vec2& before = corners[corners.size() - 2];
  return distanceTo(edge, before) > 0.0 && distanceTo(Segment{before, edge.a}, next) > 0.0;
}

}  // namespace

QString PolygonTool::hint() const {
  if (isRefused())
    return tr("The outline must not cross itself · Backspace takes the last corner back");
  if (placed().empty()) return tr("Click the corners of a building, one after the other");
  if (placed().size() < 3)
    return tr("The next corner, or type length, Tab, angle, Enter · Backspace: one back");
  return tr(
      "Enter, a double click or the first corner closes it · Backspace: one back · Esc: "
      "cancel");
}

bool PolygonTool::closesAt(const Vec2& point) const {
  return placed().size() >= 3 && (placed().front() - point).norm() <= reach(kCloseReachPx);
}

bool PolygonTool::mayPlace(const Vec2& point) const {
  return placed().size() < kMaxPolygonVertices && mayGoOn(placed(), point);
}

void PolygonTool::finish() {
  Polygon corners = placed();
  if (!isSimple(corners)) {
    refuse();
    Q_EMIT changed();
    return;
  }
  if (signedArea(corners) < 0.0) std::ranges::reverse(corners);
  Building building;
  building.shape = std::move(corners);
  cancel();
  const QString id = document().addBuilding(std::move(building));
  document().setSelection({id});
  Q_EMIT created(id);
}

void PolygonTool::paint(ToolPaint& canvas) const {
  if (!placed().empty()) {
    Polygon outline = withNext();
    if (closesAt(outline.back())) outline.back() = outline.front();
    paintOutline(canvas, outline, outline.size() > 3, isRefused() ? Role::Problem : Role::Preview);
    for (const Vec2& corner : placed()) paintHandle(canvas, corner, corner == placed().front());
  }
  DrawingTool::paint(canvas);
}

}  // namespace handmap
