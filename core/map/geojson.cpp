#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/map/map_io.h"
#include "core/map/public_tags.h"
#include "core/map/tangent_plane.h"

namespace handmap {

namespace {

using nlohmann::ordered_json;

/// [longitude, latitude] in degrees, to about 0.1 mm.
ordered_json position(const TangentPlane& plane, const Vec2& in_map) {
  const auto rounded = [](double degrees) { return std::round(degrees * 1e9) / 1e9; };
  const Vec2 degrees = plane.longitudeLatitude(in_map);
  return {rounded(degrees.x()), rounded(degrees.y())};
}

std::string feature(const std::string& geometry, ordered_json coordinates,
                    ordered_json properties) {
  const ordered_json feature = {
      {"type", "Feature"},
      {"geometry", {{"type", geometry}, {"coordinates", std::move(coordinates)}}},
      {"properties", std::move(properties)}};
  return feature.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

ordered_json propertiesOf(const Map& map, const Building& building) {
  const Uncertainty sigma = building.uncertainty.value_or(map.uncertainty);
  ordered_json properties = {{"kind", "building"},
                             {"id", building.id},
                             {"name", building.name},
                             {"sigma_position_m", sigma.position},
                             {"sigma_size_m", sigma.size}};
  if (building.estimate) {
    properties["estimate_sigma_x_m"] = building.estimate->sigma_x;
    properties["estimate_sigma_y_m"] = building.estimate->sigma_y;
    properties["estimate_sigma_width_m"] = building.estimate->sigma_width;
    properties["estimate_observations"] = building.estimate->observations;
  }
  const PublicTags kept = tagsOf(building);
  if (!kept.osm_type.empty()) properties["@id"] = kept.osm_type + "/" + kept.osm_id;
  for (const auto& [key, value] : kept.tags) {
    if (!properties.contains(key)) properties[key] = value;
  }
  return properties;
}

ordered_json positions(const TangentPlane& plane, const std::vector<Vec2>& points) {
  ordered_json result = ordered_json::array();
  for (const Vec2& point : points) result.push_back(position(plane, point));
  return result;
}

}  // namespace

std::string formatGeoJson(const Map& map) {
  if (!map.georeference) {
    throw Error(ErrorCode::BadInput,
                phrase("georeference: found nothing, expected where the map lies"),
                phrase("give the map a georeference before exporting it as GeoJSON"));
  }
  const TangentPlane plane(*map.georeference);
  std::vector<std::string> features;
  for (const Building& building : map.buildings) {
    Polygon ring = building.footprint();
    ring.push_back(ring.front());
    features.push_back(feature("Polygon", ordered_json::array({positions(plane, ring)}),
                               propertiesOf(map, building)));
  }
  for (const Landmark& landmark : map.landmarks) {
    features.push_back(
        feature("Point", position(plane, landmark.position),
                {{"kind", "landmark"}, {"id", landmark.id}, {"name", landmark.name}}));
  }
  if (map.route.size() >= 2) {
    features.push_back(feature("LineString", positions(plane, map.route), {{"kind", "route"}}));
  }
  return fmt::format("{{\"type\": \"FeatureCollection\", \"features\": [\n{}\n]}}\n",
                     fmt::join(features, ",\n"));
}

}  // namespace handmap
