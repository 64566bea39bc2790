// Which object of a map lies under a point.
#pragma once

#include <QString>

#include "widgets/document/map_change.h"

namespace handmap {

/// The key of the object at `position`: landmarks and the start before the route before buildings,
/// small buildings before those around them; empty when there is none within `reach` metres.
QString objectAt(const Map& map, const Vec2& position, double reach);

/// Keys of everything that touches the box.
QStringList objectsIn(const Map& map, const Bounds& box);

}  // namespace handmap
