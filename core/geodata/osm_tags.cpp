#include "core/geodata/osm_tags.h"

#include <unordered_map>

#include <pugixml.hpp>

#include "core/base/text.h"

namespace handmap {

namespace {

constexpr std::uintmax_t kMostXmlBytes = 64u << 20;
constexpr std::size_t kMostTagsOfOne = 1000;

}  // namespace

void takeAllTags(const std::filesystem::path& path, std::vector<GeoFeature>& features) {
  std::error_code error;
  if (std::filesystem::file_size(path, error) > kMostXmlBytes || error) return;
  pugi::xml_document document;
  const std::string text = readFile(path, kMostXmlBytes);
  if (!document.load_buffer(text.data(), text.size())) return;  // GDAL has read it, and says more
  std::unordered_map<std::string, pugi::xml_node> nodes;
  for (const pugi::xml_node node : document.child("osm").children()) {
    const std::string type = node.name();
    if (type == "way" || type == "relation") nodes[type + node.attribute("id").value()] = node;
  }
  for (GeoFeature& feature : features) {
    const auto found = nodes.find(feature.tags.osm_type + feature.tags.osm_id);
    if (feature.tags.osm_type.empty() || found == nodes.end()) continue;
    feature.tags.tags.clear();
    for (const pugi::xml_node tag : found->second.children("tag")) {
      if (feature.tags.tags.size() == kMostTagsOfOne) break;
      feature.tags.tags[tag.attribute("k").value()] = tag.attribute("v").value();
    }
  }
}

}  // namespace handmap
