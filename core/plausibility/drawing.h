// Whether a drawing can be what it says, alone and with a way on it.
#pragma once

#include <filesystem>

#include "core/map/map.h"
#include "core/plausibility/doubt.h"

namespace handmap {

/// Codes: drawing_units, strange_key. `path` names the drawing.
Doubts doubtsOfDrawing(const Map& drawing, const std::filesystem::path& path);

/// Codes: way_through_buildings, where the mirrored way keeps clear of them; else mirrored_drawing,
/// where what is seen lies on the walls of the mirrored drawing much better.
Doubts doubtsOfWay(const Recording& recording, const Map& drawing,
                   const std::filesystem::path& path, const std::stop_token& stop = {});

}  // namespace handmap
