#include "widgets/canvas/tools/polygon_tool.h"

#include <algorithm>

#include "core/map/map_limits.h"
#include "widgets/canvas/tools/tool_painting.h"

namespace handmap {

namespace {

constexpr double kReachPx = 9.0;

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
  if (refused_)
    return tr("The outline must not cross itself · Backspace takes the last corner back");
  if (corners_.empty()) return tr("Click the corners of a building, one after the other");
  if (corners_.size() < 3) return tr("Click the next corner · Backspace: one back · Esc: cancel");
  return tr(
      "Enter, a double click or the first corner closes it · Backspace: one back · Esc: "
      "cancel");
}

bool PolygonTool::cancel() {
  const bool was_busy = !corners_.empty();
  corners_.clear();
  closing_ = refused_ = false;
  if (was_busy) Q_EMIT changed();
  return was_busy;
}

bool PolygonTool::isOnFirst(const ToolEvent& event) const {
  return corners_.size() >= 3 &&
         (corners_.front() - event.position).norm() <= kReachPx * event.metres_per_pixel;
}

void PolygonTool::press(const ToolEvent& event) {
  if (isOnFirst(event)) return close();
  const bool fits = mayGoOn(corners_, event.snapped) && corners_.size() < kMaxPolygonVertices;
  if (fits) corners_.push_back(event.snapped);
  refused_ = !fits && corners_.back() != event.snapped;
  pointer_ = event.snapped;
  Q_EMIT changed();
}

void PolygonTool::move(const ToolEvent& event) {
  pointer_ = event.snapped;
  if (corners_.empty()) return;
  closing_ = isOnFirst(event);
  refused_ = !closing_ && corners_.back() != pointer_ && !mayGoOn(corners_, pointer_);
  Q_EMIT changed();
}

void PolygonTool::doubleClick(const ToolEvent&) { close(); }

bool PolygonTool::key(const ToolKey& key) {
  if (corners_.empty()) return false;
  if (key.key == Qt::Key_Backspace) {
    corners_.pop_back();
    closing_ = refused_ = false;
    Q_EMIT changed();
    return true;
  }
  if (key.key == Qt::Key_Return || key.key == Qt::Key_Enter) {
    close();
    return true;
  }
  return false;
}

void PolygonTool::close() {
  refused_ = !isSimple(corners_);
  if (refused_) {
    Q_EMIT changed();
    return;
  }
  Building building;
  if (signedArea(corners_) < 0.0) std::ranges::reverse(corners_);
  building.shape = corners_;
  cancel();
  document().setSelection({document().addBuilding(std::move(building))});
}

void PolygonTool::paint(ToolPaint& canvas) const {
  if (corners_.empty()) return;
  Polygon outline = corners_;
  outline.push_back(closing_ ? corners_.front() : pointer_);
  paintOutline(canvas, outline, outline.size() > 3, refused_ ? Role::Problem : Role::Preview);
  for (const Vec2& corner : corners_) paintHandle(canvas, corner, corner == corners_.front());
  const double length = (outline.back() - corners_.back()).norm();
  if (length > 0.0)
    paintNote(canvas, canvas.toDevice(outline.back()) + QPointF(0.0, 22.0), metresText(length));
}

}  // namespace handmap
