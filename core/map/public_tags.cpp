#include "core/map/public_tags.h"

#include <nlohmann/json.hpp>

namespace handmap {

namespace {

constexpr const char* kMember = "public_map";

/// A quoted text from `at` on, which is moved behind it; empty at the end.
std::string quotedText(std::string_view text, std::size_t& at) {
  std::string value;
  at = text.find('"', at);
  if (at == std::string_view::npos) return value;
  for (++at; at < text.size() && text[at] != '"'; ++at) {
    if (text[at] == '\\' && at + 1 < text.size()) ++at;
    value += text[at];
  }
  if (at < text.size()) ++at;
  return value;
}

}  // namespace

void addPackedTags(std::string_view text, std::map<std::string, std::string>& tags) {
  for (std::size_t at = 0; at < text.size();) {
    std::string key = quotedText(text, at);
    if (at == std::string_view::npos || text.substr(at, 2) != "=>") return;
    at += 2;
    tags[std::move(key)] = quotedText(text, at);
  }
}

void keepTags(const PublicTags& tags, Building& building) {
  if (tags.empty()) return;
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (!tags.osm_type.empty()) {
    json["type"] = tags.osm_type;
    json["id"] = tags.osm_id;
  }
  json["tags"] = tags.tags;
  building.unknown[kMember] =
      json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

PublicTags tagsOf(const Building& building) {
  PublicTags tags;
  const auto member = building.unknown.find(kMember);
  if (member == building.unknown.end()) return tags;
  const auto json = nlohmann::json::parse(member->second, nullptr, false);
  if (!json.is_object()) return tags;
  const auto text = [&](const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  tags.osm_type = text("type");
  tags.osm_id = text("id");
  const auto all = json.find("tags");
  if (all == json.end() || !all->is_object()) return tags;
  for (const auto& [key, value] : all->items()) {
    if (value.is_string()) tags.tags[key] = value.get<std::string>();
  }
  return tags;
}

}  // namespace handmap
