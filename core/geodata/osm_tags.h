// The tags of OpenStreetMap XML: GDAL passes over some of them, as notes and sources.
#pragma once

#include <filesystem>
#include <vector>

#include "core/geodata/geo_features.h"

namespace handmap {

/// Those of the ways and relations that the features are of. A file too large to be read at once
/// leaves those that they have.
void takeAllTags(const std::filesystem::path& path, std::vector<GeoFeature>& features);

}  // namespace handmap
