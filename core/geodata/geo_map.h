// Public maps as drawings: the buildings of a GeoJSON, OpenStreetMap or other geographic file, in
// metres of a plane that touches the earth in the middle of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/map/map.h"

namespace handmap {

struct GeoMap {
  Map map;                   ///< with its georeference; x is east
  std::size_t left_out = 0;  ///< outlines that no building can have: crossing themselves, too large
};

/// Whether the name is that of a geographic file that can be read.
bool isGeoFile(const std::filesystem::path& path);
/// Endings of their names, without dots.
const std::vector<std::string>& geoFileEndings();

/// Polygons that are buildings (all, where the file tells of no kinds), with their names; of what
/// this program has exported also landmarks and the route. Throws BadInput.
GeoMap readGeoMap(const std::filesystem::path& path);

}  // namespace handmap
