#include "widgets/canvas/building_handles.h"

#include <algorithm>

namespace handmap {

namespace {

constexpr double kStemPx = 26.0;

Pose2 frameOf(const Rectangle& box) { return {box.centre.x(), box.centre.y(), box.heading}; }

}  // namespace

Vec2 handlePosition(const Rectangle& box, Handle handle, double metres_per_pixel) {
  Vec2 own(handle.along * box.width / 2.0, handle.across * box.depth / 2.0);
  if (handle.turns()) own.y() = box.depth / 2.0 + kStemPx * metres_per_pixel;
  return frameOf(box).toOuter(own);
}

bool hasRoom(const Rectangle& box, Handle handle, double metres_per_pixel) {
  const bool is_corner = handle.along != 0 && handle.across != 0;
  const double side = handle.along == 0 ? box.width : box.depth;
  return handle.turns() || is_corner || side >= 4.0 * kHandleReachPx * metres_per_pixel;
}

std::optional<Handle> handleAt(const Rectangle& box, const Vec2& position,
                               double metres_per_pixel) {
  for (const Handle& handle : kHandles) {
    const double distance = (handlePosition(box, handle, metres_per_pixel) - position).norm();
    if (distance <= kHandleReachPx * metres_per_pixel && hasRoom(box, handle, metres_per_pixel))
      return handle;
  }
  return std::nullopt;
}

Rectangle resized(const Rectangle& box, Handle handle, const Vec2& position, bool centred) {
  const Vec2 pointer = frameOf(box).toOwn(position);
  Vec2 size(box.width, box.depth);
  Vec2 shift = Vec2::Zero();
  const Eigen::Vector2i sides(handle.along, handle.across);
  for (int axis = 0; axis < 2; ++axis) {
    if (sides[axis] == 0) continue;
    const double outward = sides[axis] * pointer[axis];
    const double old = size[axis];
    size[axis] = std::max(kMinSize, centred ? 2.0 * outward : outward + old / 2.0);
    if (!centred) shift[axis] = sides[axis] * (size[axis] - old) / 2.0;
  }
  return {frameOf(box).toOuter(shift), size.x(), size.y(), box.heading};
}

Rectangle turned(const Rectangle& box, const Vec2& position, double step_deg) {
  const Vec2 to_pointer = position - box.centre;
  if (to_pointer.norm() == 0.0) return box;
  Rectangle result = box;
  const double heading = std::atan2(to_pointer.y(), to_pointer.x()) - kPi / 2.0;
  result.heading = roundedHeading(heading, step_deg);
  return result;
}

Qt::CursorShape cursorOf(const Rectangle& box, Handle handle) {
  if (handle.turns()) return Qt::PointingHandCursor;
  // The screen direction in which the handle moves, in eighths of a turn.
  const double direction = box.heading + std::atan2(handle.across, handle.along);
  switch ((static_cast<int>(std::lround(direction / (kPi / 4.0))) % 4 + 4) % 4) {
    case 0:
      return Qt::SizeHorCursor;
    case 1:
      return Qt::SizeBDiagCursor;
    case 2:
      return Qt::SizeVerCursor;
    default:
      return Qt::SizeFDiagCursor;
  }
}

double roundedHeading(double heading_rad, double step_deg) {
  return toRadians(std::round(toDegrees(normalizedAngle(heading_rad)) / step_deg) * step_deg);
}

}  // namespace handmap
