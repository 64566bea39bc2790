// A rectangle, and a rectangle without one of its corners, fitted to evenly spaced samples of an
// outline.
#pragma once

#include <optional>

#include "core/geometry/polygon.h"

namespace handmap {

Rectangle fittedRectangle(const Polygon& samples);
/// Around the rectangle that fits best; nullopt where nothing speaks for a missing corner.
std::optional<Polygon> fittedLShape(const Polygon& samples, const Rectangle& rectangle);

}  // namespace handmap
