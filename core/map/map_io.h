// `.handmap` files (JSON, version 1) and exports. Every function throws handmap::Error.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/map/map.h"

namespace handmap {

/// Parses and checks; `source` names the text in messages. Throws BadInput with the JSON path.
/// A map without buildings is valid here (an empty drawing); a run refuses it.
Map parseMap(std::string_view json, const std::string& source);
Map readMap(const std::filesystem::path& path);

std::string formatMap(const Map& map);  ///< ends with a line end; equal maps give equal bytes
void writeMap(const Map& map, const std::filesystem::path& path);  ///< atomic

/// RFC 7946: WGS 84 longitude, latitude; one Feature a building or landmark; the route a
/// LineString. Throws BadInput when the map has no georeference.
std::string formatGeoJson(const Map& map);

}  // namespace handmap
