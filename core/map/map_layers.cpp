#include "core/map/map_layers.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace handmap {

namespace {

constexpr auto kMember = "handmap:layers";
constexpr std::array kNames = {"buildings", "landmarks", "start", "route"};
static_assert(kNames.size() == static_cast<std::size_t>(DrawingLayer::Count));

bool flagOf(const nlohmann::ordered_json& layer, const char* name) {
  const auto found = layer.find(name);
  return found != layer.end() && found->is_boolean() && found->get<bool>();
}

}  // namespace

LayerStates layersOf(const Map& map) {
  LayerStates states;
  const auto member = map.unknown.find(kMember);
  if (member == map.unknown.end()) return states;
  const auto json = nlohmann::ordered_json::parse(member->second, nullptr, false);
  if (!json.is_object()) return states;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto layer = json.find(kNames[i]);
    if (layer == json.end() || !layer->is_object()) continue;
    states[i].hidden = flagOf(*layer, "hidden");
    states[i].locked = flagOf(*layer, "locked");
    const auto opacity = layer->find("opacity");
    if (opacity != layer->end() && opacity->is_number())
      states[i].opacity = std::clamp(opacity->get<double>(), 0.0, 1.0);
  }
  return states;
}

void setLayers(UnknownMembers& members, const LayerStates& states) {
  auto json = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < states.size(); ++i) {
    auto layer = nlohmann::ordered_json::object();
    if (states[i].hidden) layer["hidden"] = true;
    if (states[i].locked) layer["locked"] = true;
    if (states[i].opacity != 1.0) layer["opacity"] = states[i].opacity;
    if (!layer.empty()) json[kNames[i]] = layer;
  }
  if (json.empty())
    members.erase(kMember);
  else
    members[kMember] = json.dump();
}

}  // namespace handmap
