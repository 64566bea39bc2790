// A small picture of a map, to tell one from another.
#pragma once

#include <QImage>

#include "core/map/map.h"

namespace handmap {

class Colours;

/// What is drawn, as large as it fits; an empty ground where nothing is. Pictures that the map lies
/// upon are left out. `size` is in device pixels.
QImage pictureOf(const Map& map, QSize size, const Colours& colours);

}  // namespace handmap
