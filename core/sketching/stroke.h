// A stroke as an even, closed line of points; what the fits of outlines share.
#pragma once

#include <span>

#include "core/geometry/polygon.h"

namespace handmap {

/// The ends joined, an overshoot cut off, no point twice in a row; fewer than three points:
/// nothing.
Polygon closedStroke(std::span<const Vec2> stroke);
/// So many points at even distances along the closed line.
Polygon evenlySampled(const Polygon& outline, std::size_t count);
/// Douglas–Peucker on a closed line.
Polygon simplified(const Polygon& outline, double tolerance);
double diagonalOf(const Polygon& points);  ///< of the bounding box, metres
/// The rms distance of the samples to the outline and of the outline to the samples.
double misfitOf(const Polygon& samples, const Polygon& outline);

}  // namespace handmap
