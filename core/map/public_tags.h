// What a public map says of a building beside its outline: kept in the drawing, written back.
#pragma once

#include <map>
#include <string>

#include "core/map/map.h"

namespace handmap {

struct PublicTags {
  std::string osm_type;  ///< "way" or "relation"; empty where it is not of OpenStreetMap
  std::string osm_id;
  std::map<std::string, std::string> tags;
  bool empty() const { return osm_type.empty() && tags.empty(); }
};

/// `"height"=>"3","name"=>"A"`, as GDAL gives the tags that it has no fields for.
void addPackedTags(std::string_view text, std::map<std::string, std::string>& tags);

/// In a member of the building that this program otherwise does not know.
void keepTags(const PublicTags& tags, Building& building);
/// None where there are none, or where they were damaged.
PublicTags tagsOf(const Building& building);

}  // namespace handmap
