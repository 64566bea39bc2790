// Where the name of a building is written: well inside its outline.
#pragma once

#include "core/geometry/polygon.h"

namespace handmap {

/// The point farthest from all edges, to a fiftieth of the size (the pole of inaccessibility); of a
/// convex outline its centroid, which looks better there.
Vec2 innerPoint(const Polygon& polygon);

}  // namespace handmap
