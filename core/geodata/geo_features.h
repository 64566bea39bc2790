// What a geographic file holds, as far as a drawing can have it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/map/map.h"
#include "core/map/public_tags.h"

namespace handmap {

/// Area: a polygon that the file does not tell the kind of.
enum class GeoKind { Building, Area, Landmark, Route, Other };

struct GeoFeature {
  GeoKind kind = GeoKind::Other;
  std::string id;
  std::string name;
  /// WGS 84 longitude and latitude, degrees, of a plan metres; of an area its outer ring.
  std::vector<Vec2> points;
  std::optional<Uncertainty> uncertainty;
  PublicTags tags;  ///< of a building
};

/// "osm" of "Town.OSM".
std::string lowerEnding(const std::filesystem::path& path);

/// Whether the name is that of a plan (DXF), which does not say where on earth it is.
bool isPlan(const std::filesystem::path& path);

/// A feature for each polygon, also of several that belong together. Throws BadInput.
std::vector<GeoFeature> readGeoFeatures(const std::filesystem::path& path);

}  // namespace handmap
