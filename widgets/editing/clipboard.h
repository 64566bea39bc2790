// Objects on the clipboard: as a map in JSON, so that they come through to other windows and can be
// read in any editor.
#pragma once

#include <QMimeData>
#include <memory>
#include <optional>

#include "widgets/document/map_change.h"

namespace handmap {

std::unique_ptr<QMimeData> clipboardData(const Map& map, const QStringList& keys);
/// Whether there may be objects in it.
bool mayHoldObjects(const QMimeData& data);
/// Throws Error (BadInput) for what is no map, or a damaged one.
MapChange objectsOf(const QMimeData& data);

/// The objects as copies for `map`: without what a run found out about the originals, and without
/// names that the map has already.
MapChange copiesFor(const Map& map, MapChange objects);
/// Moved so that the middle of all lies at `middle`.
MapChange centredAt(MapChange objects, const Vec2& middle);

}  // namespace handmap
