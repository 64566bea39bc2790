#include "core/map/own_members.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/json.h"
#include "core/base/text.h"
#include "core/map/map_limits.h"

namespace handmap {

namespace {

constexpr auto kHidden = "handmap:hidden";
constexpr auto kLocked = "handmap:locked";
constexpr auto kMayNotExist = "handmap:may_not_exist";
constexpr auto kSigmas = "wall_sigma_m";
constexpr auto kSeen = "walls_seen";
constexpr auto kSeenWalls = "handmap:outline_walls_seen";
constexpr auto kDoubtful = "doubtful";
constexpr auto kStart = "handmap:start_uncertainty";
constexpr auto kLayers = "handmap:layers";
constexpr auto kModel = "handmap:model";
constexpr std::array kLayerNames = {"buildings", "landmarks", "start", "route"};
static_assert(kLayerNames.size() == static_cast<std::size_t>(DrawingLayer::Count));

using Text = std::optional<std::string>;

Text textOf(const UnknownMembers& members, const char* key) {
  const auto found = members.find(key);
  return found == members.end() ? Text() : found->second;
}

/// Lets a member go where it says nothing that the field does not say.
void dropSame(UnknownMembers& members, const char* key, const std::string& formatted) {
  const auto found = members.find(key);
  if (found != members.end() && found->second == formatted) members.erase(found);
}

/// In the form of the field, unless what was read says the same (`is_same`). A field that says
/// nothing (empty) takes away what says something (`says`).
void put(UnknownMembers& members, const char* key, const std::string& formatted, bool is_same,
         bool says) {
  if (is_same) return;
  if (!formatted.empty())
    members[key] = formatted;
  else if (says)
    members.erase(key);
}

// --- Flags

bool readFlag(const Text& text) { return text == "true"; }

bool takeFlag(UnknownMembers& members, const char* key) {
  const bool on = readFlag(textOf(members, key));
  dropSame(members, key, "true");
  return on;
}

void putFlag(UnknownMembers& members, const char* key, bool on) {
  if (on) members[key] = "true";
}

void takeFlags(Flags& flags, UnknownMembers& members) {
  flags = {takeFlag(members, kHidden), takeFlag(members, kLocked)};
}

void putFlags(const Flags& flags, UnknownMembers& members) {
  putFlag(members, kHidden, flags.hidden);
  putFlag(members, kLocked, flags.locked);
}

// --- Sides and doubt

/// The four values of a JSON array of plain ones.
std::optional<std::array<std::string_view, 4>> fourOf(const Text& member) {
  if (!member) return std::nullopt;
  const std::string_view text = trimmed(*member);
  if (text.size() < 2 || text.front() != '[' || text.back() != ']') return std::nullopt;
  const auto fields = splitFields(text.substr(1, text.size() - 2), ',');
  if (fields.size() != 4) return std::nullopt;
  return std::array{fields[0], fields[1], fields[2], fields[3]};
}

std::optional<Sides> readSides(const UnknownMembers& members) {
  const Text sigma_text = textOf(members, kSigmas);
  const Text seen_text = textOf(members, kSeen);
  const auto sigmas = fourOf(sigma_text);
  const auto seen = fourOf(seen_text);
  if (!sigmas || !seen) return std::nullopt;
  Sides sides;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const auto sigma = parseFinite((*sigmas)[k]);
    if (!sigma || *sigma < 0.0) return std::nullopt;
    sides[k] = {*sigma, (*seen)[k] == "true"};
  }
  return sides;
}

std::string formatSigmas(const Sides& sides) {
  std::array<std::string, 4> sigmas;
  for (std::size_t k = 0; k < sides.size(); ++k) sigmas[k] = formatNumber(sides[k].sigma);
  return fmt::format("[{}]", fmt::join(sigmas, ","));
}

std::string formatSeen(const Sides& sides) {
  std::array<bool, 4> seen{};
  for (std::size_t k = 0; k < sides.size(); ++k) seen[k] = sides[k].seen;
  return fmt::format("[{}]", fmt::join(seen, ","));
}

/// Of an outline; empty where it is no array of true and false.
std::vector<bool> readSeenWalls(const Text& member) {
  if (!member) return {};
  const auto json = nlohmann::json::parse(*member, nullptr, false);
  if (!json.is_array()) return {};
  std::vector<bool> seen;
  for (const auto& wall : json) {
    if (!wall.is_boolean()) return {};
    seen.push_back(wall.get<bool>());
  }
  return seen;
}

std::string formatSeenWalls(const std::vector<bool>& seen) {
  return seen.empty() ? std::string() : nlohmann::json(seen).dump();
}

std::optional<double> readDoubt(const Text& text) {
  return text ? parseFinite(*text) : std::nullopt;
}

// --- Start, layers, model

std::optional<StartUncertainty> readStart(const Text& text, const std::string& source) {
  if (!text) return std::nullopt;
  const auto parsed = parseJson("{\"" + std::string(kStart) + "\":" + *text + "}", source);
  const JsonValue json = JsonValue(parsed, source).at(kStart).object();
  StartUncertainty uncertainty;
  if (const auto sigma = json.find("position_m")) {
    uncertainty.position = sigma->number(0.0, kMaxSigma);
  }
  if (const auto sigma = json.find("heading_deg")) {
    uncertainty.heading = toRadians(sigma->number(0.0, kMaxTurnSigmaDeg));
  }
  return uncertainty;
}

/// What people type stays what they typed.
double thousandths(double value) { return std::round(value * 1000.0) / 1000.0; }

std::string formatStart(const StartUncertainty& start) {
  const nlohmann::json json{{"position_m", thousandths(start.position)},
                            {"heading_deg", thousandths(toDegrees(start.heading))}};
  return json.dump();
}

bool flagOf(const nlohmann::ordered_json& layer, const char* name) {
  const auto found = layer.find(name);
  return found != layer.end() && found->is_boolean() && found->get<bool>();
}

LayerStates readLayers(const Text& text) {
  LayerStates states;
  if (!text) return states;
  const auto json = nlohmann::ordered_json::parse(*text, nullptr, false);
  if (!json.is_object()) return states;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto layer = json.find(kLayerNames[i]);
    if (layer == json.end() || !layer->is_object()) continue;
    states[i].hidden = flagOf(*layer, "hidden");
    states[i].locked = flagOf(*layer, "locked");
    const auto opacity = layer->find("opacity");
    if (opacity != layer->end() && opacity->is_number())
      states[i].opacity = std::clamp(opacity->get<double>(), 0.0, 1.0);
  }
  return states;
}

/// Empty where they are as usual.
std::string formatLayers(const LayerStates& states) {
  auto json = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < states.size(); ++i) {
    auto layer = nlohmann::ordered_json::object();
    if (states[i].hidden) layer["hidden"] = true;
    if (states[i].locked) layer["locked"] = true;
    if (states[i].opacity != 1.0) layer["opacity"] = states[i].opacity;
    if (!layer.empty()) json[kLayerNames[i]] = layer;
  }
  return json.empty() ? std::string() : json.dump();
}

/// Empty for what is no path.
std::string readModel(const Text& text) {
  if (!text) return {};
  const auto json = nlohmann::json::parse(*text, nullptr, false);
  if (!json.is_string()) return {};
  std::string path = json.get<std::string>();
  return path.size() <= kMaxTextBytes ? path : std::string();
}

}  // namespace

void takeOwnMembers(Building& building) {
  UnknownMembers& members = building.unknown;
  if (members.empty()) return;
  takeFlags(building.flags, members);
  building.may_not_exist = takeFlag(members, kMayNotExist);
  building.sides = readSides(members);
  if (building.sides && textOf(members, kSigmas) == formatSigmas(*building.sides) &&
      textOf(members, kSeen) == formatSeen(*building.sides)) {
    members.erase(kSigmas);
    members.erase(kSeen);
  }
  building.seen_walls = readSeenWalls(textOf(members, kSeenWalls));
  dropSame(members, kSeenWalls, formatSeenWalls(building.seen_walls));
  building.doubt = readDoubt(textOf(members, kDoubtful));
  if (building.doubt) dropSame(members, kDoubtful, formatNumber(*building.doubt));
}

void takeOwnMembers(Landmark& landmark) { takeFlags(landmark.flags, landmark.unknown); }

void takeOwnMembers(Underlay& underlay) { takeFlags(underlay.flags, underlay.unknown); }

void takeOwnMembers(Map& map, const std::string& source) {
  UnknownMembers& members = map.unknown;
  map.start_uncertainty = readStart(textOf(members, kStart), source);
  if (map.start_uncertainty) dropSame(members, kStart, formatStart(*map.start_uncertainty));
  map.layers = readLayers(textOf(members, kLayers));
  dropSame(members, kLayers, formatLayers(map.layers));
  map.model = readModel(textOf(members, kModel));
  if (!map.model.empty()) dropSame(members, kModel, quotedJson(map.model));
}

UnknownMembers withOwnMembers(const Building& building) {
  UnknownMembers members = building.unknown;
  putFlags(building.flags, members);
  putFlag(members, kMayNotExist, building.may_not_exist);
  const std::optional<Sides> were = readSides(members);
  const bool same_sides = were == building.sides;
  put(members, kSigmas, building.sides ? formatSigmas(*building.sides) : "", same_sides,
      were.has_value());
  put(members, kSeen, building.sides ? formatSeen(*building.sides) : "", same_sides,
      were.has_value());
  const std::vector<bool> outlined = readSeenWalls(textOf(members, kSeenWalls));
  put(members, kSeenWalls, formatSeenWalls(building.seen_walls), outlined == building.seen_walls,
      !outlined.empty());
  const std::optional<double> doubted = readDoubt(textOf(members, kDoubtful));
  put(members, kDoubtful, building.doubt ? formatNumber(*building.doubt) : "",
      doubted == building.doubt, doubted.has_value());
  return members;
}

UnknownMembers withOwnMembers(const Landmark& landmark) {
  UnknownMembers members = landmark.unknown;
  putFlags(landmark.flags, members);
  return members;
}

UnknownMembers withOwnMembers(const Underlay& underlay) {
  UnknownMembers members = underlay.unknown;
  putFlags(underlay.flags, members);
  return members;
}

UnknownMembers withOwnMembers(const Map& map) {
  UnknownMembers members = map.unknown;
  const auto started = readStart(textOf(members, kStart), "map");
  put(members, kStart, map.start_uncertainty ? formatStart(*map.start_uncertainty) : "",
      started == map.start_uncertainty, started.has_value());
  const LayerStates usual{};
  const LayerStates layered = readLayers(textOf(members, kLayers));
  put(members, kLayers, formatLayers(map.layers), layered == map.layers, layered != usual);
  const std::string model = readModel(textOf(members, kModel));
  put(members, kModel, map.model.empty() ? "" : quotedJson(map.model), model == map.model,
      !model.empty());
  return members;
}

}  // namespace handmap
