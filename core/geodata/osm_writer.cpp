#include <algorithm>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/geodata/geo_writer.h"
#include "core/map/public_tags.h"
#include "core/map/tangent_plane.h"

namespace handmap {

namespace {

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20) safe += c;  // XML has no others
    }
  }
  return safe;
}

using Tags = std::map<std::string, std::string>;

std::string formatTags(const Tags& tags) {
  std::string text;
  for (const auto& [key, value] : tags) {
    text += fmt::format("    <tag k=\"{}\" v=\"{}\"/>\n", escaped(key), escaped(value));
  }
  return text;
}

Tags tagsForOsm(const Building& building, const PublicTags& kept) {
  Tags tags = kept.tags;
  tags.emplace("building", "yes");
  if (!building.name.empty()) tags.emplace("name", building.name);
  if (kept.osm_type.empty()) tags.emplace("handmap:id", building.id);
  if (const auto& estimate = building.estimate) {
    tags["handmap:sigma_x"] = fmt::format("{:.2f}", estimate->sigma_x);
    tags["handmap:sigma_y"] = fmt::format("{:.2f}", estimate->sigma_y);
    tags["handmap:sigma_width"] = fmt::format("{:.2f}", estimate->sigma_width);
  }
  return tags;
}

/// What came from there has a number above 0, and is to be changed.
std::string element(const char* name, std::int64_t number, const std::string& content) {
  return fmt::format("  <{} id=\"{}\" visible=\"true\"{}>\n{}  </{}>\n", name, number,
                     number > 0 ? " action=\"modify\"" : "", content, name);
}

}  // namespace

std::string formatOsm(const Map& map) {
  if (!map.georeference) {
    throw Error(ErrorCode::BadInput,
                phrase("georeference: found nothing, expected where the map lies"),
                phrase("give the map a georeference before exporting it as OpenStreetMap"));
  }
  const TangentPlane plane(*map.georeference);
  std::string nodes;
  // Readers want both in the order of their numbers.
  std::map<std::int64_t, std::string> ways;
  std::map<std::int64_t, std::string> relations;
  std::int64_t next = 0;  // what is new has numbers below 0
  for (const Building& building : map.buildings) {
    next -= 1 + static_cast<std::int64_t>(building.footprint().size());
  }
  for (const Building& building : map.buildings) {
    const PublicTags kept = tagsOf(building);
    const std::int64_t known = std::max<std::int64_t>(0, parseInteger(kept.osm_id).value_or(0));
    const bool is_relation = known > 0 && kept.osm_type == "relation" && !relations.contains(known);
    const bool is_way = known > 0 && kept.osm_type == "way" && !ways.contains(known);
    std::string references;
    const std::int64_t first = next;
    for (const Vec2& corner : building.footprint()) {
      const Vec2 degrees = plane.longitudeLatitude(corner);
      nodes += fmt::format("  <node id=\"{}\" lat=\"{:.9f}\" lon=\"{:.9f}\" visible=\"true\"/>\n",
                           next, degrees.y(), degrees.x());
      references += fmt::format("    <nd ref=\"{}\"/>\n", next++);
    }
    references += fmt::format("    <nd ref=\"{}\"/>\n", first);
    const std::int64_t number = is_way ? known : next;
    ++next;
    Tags tags = tagsForOsm(building, kept);
    if (is_relation) {
      // An old one has the tags of the building at its outline.
      const bool is_old = !kept.tags.contains("building");
      relations[known] =
          element("relation", known,
                  fmt::format("    <member type=\"way\" ref=\"{}\" role=\"outer\"/>\n", number) +
                      formatTags(is_old ? kept.tags : tags));
      std::erase_if(tags,
                    [&](const auto& tag) { return !is_old || kept.tags.contains(tag.first); });
    }
    ways[number] = element("way", number, references + formatTags(tags));
  }
  std::string all = nodes;
  for (const auto* elements : {&ways, &relations}) {
    for (const auto& [number, text] : *elements) all += text;
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<osm version=\"0.6\" generator=\"handmap\">\n{}</osm>\n",
      all);
}

}  // namespace handmap
