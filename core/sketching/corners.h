// Corners of an outline moved, added and taken away. What would make the outline cross itself is
// refused.
#pragma once

#include <cstddef>
#include <optional>

#include "core/geometry/polygon.h"

namespace handmap {

std::optional<Polygon> withCornerAt(Polygon outline, std::size_t corner, const Vec2& position);
/// The new corner is number `edge` + 1.
std::optional<Polygon> withCornerOn(Polygon outline, std::size_t edge, const Vec2& position);
std::optional<Polygon> withoutCorner(Polygon outline, std::size_t corner);

/// The nearest within `reach` metres.
std::optional<std::size_t> cornerNear(const Polygon& outline, const Vec2& point, double reach);
/// Of the first `edges` edges.
std::optional<std::size_t> edgeNear(const Polygon& outline, const Vec2& point, double reach,
                                    std::size_t edges);
Segment edgeOf(const Polygon& outline, std::size_t edge);  ///< from corner `edge` to the next

}  // namespace handmap
