// What becomes of selected objects when they are arranged. Pure: from a map and keys to a change.
// What is locked stays where it is, and the others are arranged with it.
#pragma once

#include "widgets/document/map_change.h"

namespace handmap {

enum class Alignment { Left, Right, Top, Bottom, CentreX, CentreY };
enum class Along { X, Y };

/// The boxes around the objects laid along the outermost one's side, or along the middle of all.
MapChange aligned(const Map& map, const QStringList& keys, Alignment alignment);
/// The same gap between neighbours; the outermost two stay.
MapChange distributed(const Map& map, const QStringList& keys, Along along);
/// Polygons get right angles where they nearly have them; rectangles that lie within 10° of the
/// map's axes are laid along them.
MapChange squaredUp(const Map& map, const QStringList& keys);
/// Each building turned, by less than 45°, to the direction of the selected one that is locked or
/// the largest; one alone, to that of the nearest.
MapChange madeParallel(const Map& map, const QStringList& keys);
/// Turned by 90° about the middle of all.
MapChange turnedByQuarter(const Map& map, const QStringList& keys, bool clockwise);
/// Left and right exchanged (X), or top and bottom (Y), about the middle of all.
MapChange mirrored(const Map& map, const QStringList& keys, Along along);
/// All of a map, locked or not, in other units: `factor` of them in one of these.
MapChange scaled(const Map& map, double factor);
/// Copies in columns and rows, each `step` metres from the one before; the selected are the first.
MapChange arrayed(const Map& map, const QStringList& keys, int columns, int rows, const Vec2& step);
/// Rectangles as polygons, so that their corners can be moved alone.
MapChange asPolygons(const Map& map, const QStringList& keys);
/// Locked, or unlocked when all were locked.
MapChange lockToggled(const Map& map, const QStringList& keys);

}  // namespace handmap
