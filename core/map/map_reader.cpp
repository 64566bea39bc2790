#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/map/map_io.h"
#include "core/map/map_limits.h"
#include "core/map/own_members.h"

namespace handmap {

namespace {

double coordinate(const JsonValue& value) { return value.number(-kMaxCoordinate, kMaxCoordinate); }

double heading(const JsonValue& value) {
  return toRadians(value.number(-kMaxHeadingDeg, kMaxHeadingDeg));
}

Vec2 point(const JsonValue& value) {
  const auto numbers = value.items(2);
  if (numbers.size() != 2) value.fail("[x, y]");
  return {coordinate(numbers[0]), coordinate(numbers[1])};
}

Vec2 position(const JsonValue& object) {
  return {coordinate(object.at("x")), coordinate(object.at("y"))};
}

std::string requiredText(const JsonValue& value) {
  std::string text = value.text(kMaxTextBytes);
  if (text.empty()) value.fail(phrase("a string that is not empty"));
  return text;
}

/// Members that a part without room for them has beyond `known` are kept in its owner, as an object
/// under the key of the part (the writer's Members::addKept() is the inverse).
void keepOthers(const JsonValue& part, const std::string& key,
                const std::vector<std::string_view>& known, UnknownMembers& kept) {
  std::string text;
  for (const auto& [name, value] : part.others(known)) {
    text += fmt::format("{}{}:{}", text.empty() ? "" : ",", quotedJson(name), value);
  }
  if (!text.empty()) kept[key] = "{" + text + "}";
}

Uncertainty readUncertainty(const JsonValue& json, const Uncertainty& fallback) {
  Uncertainty result = fallback;
  if (const auto sigma = json.find("position_m")) result.position = sigma->number(0.0, kMaxSigma);
  if (const auto sigma = json.find("size_m")) result.size = sigma->number(0.0, kMaxSigma);
  return result;
}

WholeUncertainty readWholeUncertainty(const JsonValue& json) {
  WholeUncertainty result;
  if (const auto sigma = json.find("scale")) result.scale = sigma->number(0.0, kMaxScaleSigma);
  if (const auto sigma = json.find("turn_deg")) {
    result.turn = toRadians(sigma->number(0.0, kMaxTurnSigmaDeg));
  }
  if (const auto sigma = json.find("shift_m")) result.shift = sigma->number(0.0, kMaxSigma);
  return result;
}

Estimate readEstimate(const JsonValue& json) {
  return {json.at("sigma_x").number(0.0, kMaxSigma), json.at("sigma_y").number(0.0, kMaxSigma),
          json.at("sigma_width").number(0.0, kMaxSigma),
          static_cast<int>(json.at("observations").integer(0, 1'000'000'000))};
}

/// A corner given twice in a row, as when the ring is closed by hand, counts once.
Polygon readPolygon(const JsonValue& vertices) {
  Polygon polygon;
  constexpr std::size_t kClosed = kMaxPolygonVertices + 1;
  for (const JsonValue& item : vertices.items(kClosed)) polygon.push_back(point(item));
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  while (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
  if (polygon.size() < 3 || polygon.size() > kMaxPolygonVertices) {
    vertices.fail(phrase("{} different vertices", polygon.size()),
                  phrase("3 to {}", kMaxPolygonVertices));
  }
  const double area = signedArea(polygon);
  if (area < 0.0) std::reverse(polygon.begin() + 1, polygon.end());
  if (std::abs(area) < kMinPolygonArea) {
    vertices.fail(phrase("a polygon without area"), phrase("some area"));
  }
  if (!isSimple(polygon)) {
    vertices.fail(phrase("a polygon that meets itself"), phrase("a simple polygon"));
  }
  return polygon;
}

std::vector<std::string_view> readShape(const JsonValue& json, Building& building) {
  const std::string shape = json.at("shape").text(kMaxTextBytes);
  if (shape == "rectangle") {
    building.shape =
        Rectangle{position(json), json.at("width").positive(kMaxSize),
                  json.at("depth").positive(kMaxSize), heading(json.at("heading_deg"))};
    return {"x", "y", "width", "depth", "heading_deg"};
  }
  if (shape != "polygon") json.at("shape").fail(phrase("\"rectangle\" or \"polygon\""));
  building.shape = readPolygon(json.at("vertices"));
  return {"vertices"};
}

Building readBuilding(const JsonValue& json, const Uncertainty& of_map) {
  Building building;
  building.id = requiredText(json.at("id"));
  building.name = json.textOr("name", kMaxTextBytes, "");
  std::vector<std::string_view> known = readShape(json, building);
  known.insert(known.end(), {"id", "name", "shape", "uncertainty", "fixed", "estimate"});
  building.unknown = json.others(known);
  if (const auto part = json.find("uncertainty")) {
    building.uncertainty = readUncertainty(*part, of_map);
    keepOthers(*part, "uncertainty", {"position_m", "size_m"}, building.unknown);
  }
  if (const auto fixed = json.find("fixed")) building.fixed = fixed->flag();
  if (const auto part = json.find("estimate")) {
    building.estimate = readEstimate(*part);
    keepOthers(*part, "estimate", {"sigma_x", "sigma_y", "sigma_width", "observations"},
               building.unknown);
  }
  takeOwnMembers(building);
  return building;
}

std::size_t verticesOf(const Building& building) {
  const auto* polygon = std::get_if<Polygon>(&building.shape);
  return polygon == nullptr ? 4 : polygon->size();
}

Landmark readLandmark(const JsonValue& json) {
  Landmark landmark;
  landmark.id = requiredText(json.at("id"));
  landmark.name = json.textOr("name", kMaxTextBytes, "");
  landmark.position = position(json);
  landmark.unknown = json.others({"id", "name", "x", "y"});
  takeOwnMembers(landmark);
  return landmark;
}

Underlay readUnderlay(const JsonValue& json) {
  Underlay underlay;
  underlay.image = requiredText(json.at("image"));
  underlay.x = coordinate(json.at("x"));
  underlay.y = coordinate(json.at("y"));
  underlay.metres_per_pixel = json.at("metres_per_pixel").positive(kMaxMetresPerPixel);
  if (const auto value = json.find("heading_deg")) underlay.heading = heading(*value);
  if (const auto value = json.find("opacity")) underlay.opacity = value->number(0.0, 1.0);
  underlay.unknown = json.others({"image", "x", "y", "metres_per_pixel", "heading_deg", "opacity"});
  takeOwnMembers(underlay);
  return underlay;
}

Georeference readGeoreference(const JsonValue& json) {
  Georeference result;
  result.latitude = json.at("latitude").number(-kMaxLatitudeDeg, kMaxLatitudeDeg);
  result.longitude = json.at("longitude").number(-180.0, 180.0);
  if (const auto value = json.find("heading_deg")) result.heading = heading(*value);
  result.unknown = json.others({"latitude", "longitude", "heading_deg"});
  return result;
}

void checkFormat(const JsonValue& json) {
  if (json.at("format").text(kMaxTextBytes) != "handmap") json.at("format").fail("\"handmap\"");
  const auto version = json.at("version").integer(1, INT64_MAX);
  if (version > kMapVersion) {
    throw Error(ErrorCode::BadInput,
                phrase("{}: version: found {}, this program reads up to {}", json.source(), version,
                       kMapVersion),
                phrase("update the program to open this map"));
  }
}

std::vector<JsonValue> itemsOf(const JsonValue& json, const std::string& key, std::size_t most) {
  const auto value = json.find(key);
  return value ? value->items(most) : std::vector<JsonValue>{};
}

/// Remembers where each id was seen.
class Ids {
 public:
  void add(const std::string& id, const JsonValue& object) {
    const auto [first, is_new] = seen_.try_emplace(id, object.path());
    if (is_new) return;
    const JsonValue place = object.at("id");
    place.fail(phrase("{}, the id of {}", quotedJson(id), first->second),
               phrase("an id that is unique in the file"));
  }

 private:
  std::map<std::string, std::string> seen_;
};

}  // namespace

Map parseMap(std::string_view text, const std::string& source) {
  const auto parsed = parseJson(text, source);
  const JsonValue json(parsed, source);
  checkFormat(json);

  Map map;
  map.unknown = json.others({"format", "version", "name", "start", "uncertainty", "buildings",
                             "landmarks", "route", "underlays", "georeference", "refinement"});
  takeOwnMembers(map, source);
  map.name = json.textOr("name", kMaxTextBytes, "");
  if (const auto start = json.find("start")) {
    const Vec2 at = position(*start);
    map.start = Pose2{at.x(), at.y(), heading(start->at("heading_deg"))};
    keepOthers(*start, "start", {"x", "y", "heading_deg"}, map.unknown);
  }
  if (const auto part = json.find("uncertainty")) {
    map.uncertainty = readUncertainty(*part, {});
    map.whole = readWholeUncertainty(*part);
    keepOthers(*part, "uncertainty", {"position_m", "size_m", "scale", "turn_deg", "shift_m"},
               map.unknown);
  }
  Ids ids;
  std::size_t vertices = 0;
  for (const JsonValue& item : json.at("buildings").items(kMaxBuildings)) {
    map.buildings.push_back(readBuilding(item, map.uncertainty));
    ids.add(map.buildings.back().id, item);
    vertices += verticesOf(map.buildings.back());
    if (vertices > kMaxVertices) {
      item.fail(phrase("{} vertices up to here", vertices),
                phrase("at most {} in all", kMaxVertices));
    }
  }
  for (const JsonValue& item : itemsOf(json, "landmarks", kMaxLandmarks)) {
    map.landmarks.push_back(readLandmark(item));
    ids.add(map.landmarks.back().id, item);
  }
  for (const JsonValue& item : itemsOf(json, "route", kMaxRoutePoints))
    map.route.push_back(point(item));
  for (const JsonValue& item : itemsOf(json, "underlays", kMaxUnderlays)) {
    map.underlays.push_back(readUnderlay(item));
  }
  if (const auto part = json.find("georeference")) map.georeference = readGeoreference(*part);
  if (const auto part = json.find("refinement")) map.refinement = part->object().dump();
  return map;
}

Map readMap(const std::filesystem::path& path) {
  return parseMap(readFile(path, kMaxMapBytes), path.string());
}

}  // namespace handmap
