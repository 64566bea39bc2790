// Outlines made straight: right angles, and turns to a common direction.
#pragma once

#include <optional>

#include "core/geometry/polygon.h"

namespace handmap {

/// The heading in [0, π/2) that most of the outline's length follows, its walls taken modulo a
/// right angle.
double commonHeading(const Polygon& polygon);

/// The outline with each wall laid along the common heading or across it, at the place that its
/// length balances; walls that lie between the two by more than `tolerance_rad` keep their way.
/// Walls in a row that become parallel become one. Counter-clockwise; nullopt where that leaves no
/// simple outline.
std::optional<Polygon> squaredUp(const Polygon& polygon, double tolerance_rad = toRadians(25.0));

/// The least turn (radians, in [-π/4, π/4]) that brings `heading_rad` to `target_rad` modulo a
/// right angle.
double turnToParallel(double heading_rad, double target_rad);

}  // namespace handmap
