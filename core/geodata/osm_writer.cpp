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

std::map<std::string, std::string> tagsForOsm(const Building& building, const PublicTags& kept) {
  std::map<std::string, std::string> tags = kept.tags;
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

}  // namespace

std::string formatOsm(const Map& map) {
  if (!map.georeference) {
    throw Error(ErrorCode::BadInput,
                phrase("georeference: found nothing, expected where the map lies"),
                phrase("give the map a georeference before exporting it as OpenStreetMap"));
  }
  const TangentPlane plane(*map.georeference);
  std::string nodes;
  std::map<std::int64_t, std::string> ways;  // readers want both in the order of their numbers
  std::int64_t next = 0;                     // what is new has numbers below 0
  for (const Building& building : map.buildings) {
    next -= 1 + static_cast<std::int64_t>(building.footprint().size());
  }
  for (const Building& building : map.buildings) {
    const PublicTags kept = tagsOf(building);
    const auto known = kept.osm_type == "way" ? parseInteger(kept.osm_id) : std::nullopt;
    const bool is_known = known && *known > 0 && !ways.contains(*known);
    std::string references;
    const std::int64_t first = next;
    for (const Vec2& corner : building.footprint()) {
      const Vec2 degrees = plane.longitudeLatitude(corner);
      nodes += fmt::format("  <node id=\"{}\" lat=\"{:.9f}\" lon=\"{:.9f}\" visible=\"true\"/>\n",
                           next, degrees.y(), degrees.x());
      references += fmt::format("    <nd ref=\"{}\"/>\n", next++);
    }
    references += fmt::format("    <nd ref=\"{}\"/>\n", first);
    const std::int64_t number = is_known ? *known : next;
    ++next;
    std::string& way = ways[number];
    way = fmt::format("  <way id=\"{}\" visible=\"true\"{}>\n{}", number,
                      is_known ? " action=\"modify\"" : "", references);
    for (const auto& [key, value] : tagsForOsm(building, kept)) {
      way += fmt::format("    <tag k=\"{}\" v=\"{}\"/>\n", escaped(key), escaped(value));
    }
    way += "  </way>\n";
  }
  std::string all = nodes;
  for (const auto& [number, way] : ways) all += way;
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<osm version=\"0.6\" generator=\"handmap\">\n{}</osm>\n",
      all);
}

}  // namespace handmap
