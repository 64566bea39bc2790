// A map on a sheet of A4, to be printed or shown: outlines with their names, start, way and
// landmarks, a scale bar and a legend.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/map/map.h"

namespace handmap {

/// "pdf", "svg", "png".
const std::vector<std::string>& planEndings();

/// The bytes of a file of the kind that its name's ending tells. Where the map was corrected, blue
/// is what a run has seen. Of names that a PNG has no letters for (others than ASCII) the ids are
/// written. Throws BadInput for another ending and for a map with nothing on it.
std::string formatPlan(const Map& map, const std::filesystem::path& path);

/// Of a scale bar: 1, 2 or 5 times a power of ten, at most so much.
double roundLength(double most);

}  // namespace handmap
