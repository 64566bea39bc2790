// The handles around a building: eight to resize it in its own axes, one to turn it.
#pragma once

#include <Qt>
#include <array>
#include <optional>

#include "core/geometry/polygon.h"

namespace handmap {

inline constexpr double kHandleReachPx = 8.0;  ///< around the middle of a handle

/// Which sides of the box follow the pointer: -1, 0 or 1 along its width and its depth. (0, 0) is
/// the handle that turns.
struct Handle {
  int along = 0;
  int across = 0;
  bool turns() const { return along == 0 && across == 0; }
};

inline constexpr std::array<Handle, 9> kHandles = {
    {{0, 0}, {-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}}};

inline constexpr double kMinSize = 0.1;  ///< of a building, metres

Vec2 handlePosition(const Rectangle& box, Handle handle, double metres_per_pixel);
/// Handles in the middle of a side give way where they would crowd the corners.
bool hasRoom(const Rectangle& box, Handle handle, double metres_per_pixel);
std::optional<Handle> handleAt(const Rectangle& box, const Vec2& position, double metres_per_pixel);

/// The box with the handle's sides at `position`, the opposite ones where they were; with `centred`
/// the centre stays instead. Not smaller than kMinSize.
Rectangle resized(const Rectangle& box, Handle handle, const Vec2& position, bool centred);
/// The box turned about its centre until its handle points at `position`, to whole `step_deg`.
Rectangle turned(const Rectangle& box, const Vec2& position, double step_deg);

Qt::CursorShape cursorOf(const Rectangle& box, Handle handle);

/// An angle rounded to whole steps of so many degrees.
double roundedHeading(double heading_rad, double step_deg);

}  // namespace handmap
