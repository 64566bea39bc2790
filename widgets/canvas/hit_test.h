// Which object of a drawing lies under a point.
#pragma once

#include <QString>

#include "widgets/document/map_document.h"

namespace handmap {

/// The key of the object at `position`: landmarks and the start before the route before buildings,
/// small buildings before those around them; empty when there is none within `reach` metres.
QString objectAt(const MapDocument& document, const Vec2& position, double reach);

/// Keys of everything that touches the box.
QStringList objectsIn(const MapDocument& document, const Bounds& box);

}  // namespace handmap
