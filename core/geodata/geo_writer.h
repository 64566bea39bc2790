// Drawings and corrected maps for other programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/map/map.h"

namespace handmap {

/// Endings of the files that it can be written as: geojson, osm, kml, gpkg, dxf (metres of the
/// map), yaml: of map_server, with a .pgm beside; named NAME.building.yaml Open-RMF's, and
/// NAME.fleet.yaml the reference coordinates of a robot's map.
const std::vector<std::string>& writableEndings();

/// Whether its ending is one of those that say where on earth a map lies.
bool needsGeoreference(const std::filesystem::path& path);

/// Whether a .pgm is written beside.
bool isMapServer(const std::filesystem::path& path);

/// By the ending; the old file stays whole where it fails. See
/// needsGeoreference(). Throws BadInput or RunFailed.
void writeGeoMap(const Map& map, const std::filesystem::path& path);

/// OpenStreetMap XML. Buildings that came from there keep their numbers and tags; σ stand beside
/// in tags of their own ("handmap:sigma_x").
std::string formatOsm(const Map& map);

}  // namespace handmap
