#include <algorithm>
#include <cmath>
#include <set>

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

/// Equal values give equal text: no negative zero.
std::string number(double value) {
  if (!std::isfinite(value)) {
    throw Error(ErrorCode::RunFailed, phrase("the map holds a number that is not finite"));
  }
  return formatNumber(value + 0.0);
}

double rounded(double value, double step) {
  const double steps = std::round(1.0 / step);
  return std::round(value * steps) / steps;
}

constexpr double kMillimetre = 1e-3;

/// What is drawn by hand is no finer, and files stay readable.
std::string metres(double value) { return number(rounded(value, kMillimetre)); }

/// Of something that has an extent, however small.
std::string size(double value) { return value < kMillimetre ? number(value) : metres(value); }

std::string degrees(double radians) {
  double angle = toDegrees(radians);
  if (std::abs(angle) > kMaxHeadingDeg) angle = std::remainder(angle, 360.0);
  return number(rounded(angle, 1e-3));
}

std::string points(const std::vector<Vec2>& points) {
  std::vector<std::string> texts;
  texts.reserve(points.size());
  for (const Vec2& p : points) {
    texts.push_back(fmt::format("[{}, {}]", number(p.x()), number(p.y())));
  }
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::vector<Vec2> toMillimetres(std::vector<Vec2> points) {
  for (Vec2& p : points) p = {rounded(p.x(), kMillimetre), rounded(p.y(), kMillimetre)};
  return points;
}

/// Whole where whole millimetres would make another outline of it.
Polygon outline(const Polygon& polygon) {
  Polygon whole = toMillimetres(polygon);
  const bool same = isSimple(whole) && signedArea(whole) >= kMinPolygonArea;
  return same ? whole : polygon;
}

/// The members of an object in the order in which they were added.
class Members {
 public:
  Members& add(const std::string& key, const std::string& json) {
    members_.push_back(fmt::format("{}: {}", quotedJson(key), json));
    keys_.insert(key);
    return *this;
  }

  /// Adds what the file had and this version does not know. The members that belong into `parts`
  /// are left to addKept().
  Members& addUnknown(const UnknownMembers& unknown, const std::set<std::string>& parts = {}) {
    for (const auto& [key, json] : unknown) {
      if (!keys_.contains(key) && !parts.contains(key)) add(key, json);
    }
    return *this;
  }

  /// Adds the unknown members of the part `key` that the reader has kept in its owner.
  Members& addKept(const UnknownMembers& of_owner, const std::string& key) {
    const auto kept = of_owner.find(key);
    if (kept != of_owner.end()) {
      members_.push_back(kept->second.substr(1, kept->second.size() - 2));
    }
    return *this;
  }

  std::string line() const { return fmt::format("{{{}}}", fmt::join(members_, ", ")); }
  std::string block() const { return fmt::format("{{\n  {}\n}}\n", fmt::join(members_, ",\n  ")); }

 private:
  std::vector<std::string> members_;
  std::set<std::string> keys_;
};

Members uncertaintyMembers(const Uncertainty& uncertainty) {
  return Members()
      .add("position_m", metres(uncertainty.position))
      .add("size_m", metres(uncertainty.size));
}

Members uncertaintyMembers(const Map& map) {
  Members members = uncertaintyMembers(map.uncertainty);
  if (map.whole.scale) members.add("scale", number(*map.whole.scale));
  if (map.whole.turn) members.add("turn_deg", degrees(*map.whole.turn));
  if (map.whole.shift) members.add("shift_m", metres(*map.whole.shift));
  return members;
}

/// An estimate may know less than a file may say.
std::string sigma(double sigma_m) { return metres(std::min(sigma_m, kMaxSigma)); }

Members estimateMembers(const Estimate& estimate) {
  return Members()
      .add("sigma_x", sigma(estimate.sigma_x))
      .add("sigma_y", sigma(estimate.sigma_y))
      .add("sigma_width", sigma(estimate.sigma_width))
      .add("observations", std::to_string(estimate.observations));
}

void addShape(const Building& building, Members& members) {
  if (const auto* rectangle = std::get_if<Rectangle>(&building.shape)) {
    members.add("shape", "\"rectangle\"")
        .add("x", metres(rectangle->centre.x()))
        .add("y", metres(rectangle->centre.y()))
        .add("width", size(rectangle->width))
        .add("depth", size(rectangle->depth))
        .add("heading_deg", degrees(rectangle->heading));
  } else {
    members.add("shape", "\"polygon\"")
        .add("vertices", points(outline(std::get<Polygon>(building.shape))));
  }
}

std::string buildingLine(const Building& building) {
  const UnknownMembers& unknown = building.unknown;
  Members members;
  members.add("id", quotedJson(building.id));
  if (!building.name.empty()) members.add("name", quotedJson(building.name));
  addShape(building, members);
  if (building.uncertainty) {
    members.add("uncertainty",
                uncertaintyMembers(*building.uncertainty).addKept(unknown, "uncertainty").line());
  }
  if (building.fixed) members.add("fixed", "true");
  if (building.estimate) {
    members.add("estimate",
                estimateMembers(*building.estimate).addKept(unknown, "estimate").line());
  }
  return members.addUnknown(withOwnMembers(building), {"uncertainty", "estimate"}).line();
}

std::string landmarkLine(const Landmark& landmark) {
  Members members;
  members.add("id", quotedJson(landmark.id));
  if (!landmark.name.empty()) members.add("name", quotedJson(landmark.name));
  return members.add("x", metres(landmark.position.x()))
      .add("y", metres(landmark.position.y()))
      .addUnknown(withOwnMembers(landmark))
      .line();
}

std::string underlayLine(const Underlay& underlay) {
  return Members()
      .add("image", quotedJson(underlay.image))
      .add("x", metres(underlay.x))
      .add("y", metres(underlay.y))
      .add("metres_per_pixel", number(underlay.metres_per_pixel))
      .add("heading_deg", degrees(underlay.heading))
      .add("opacity", number(underlay.opacity))
      .addUnknown(withOwnMembers(underlay))
      .line();
}

std::string georeferenceLine(const Georeference& georeference) {
  return Members()
      .add("latitude", number(georeference.latitude))
      .add("longitude", number(georeference.longitude))
      .add("heading_deg", degrees(georeference.heading))
      .addUnknown(georeference.unknown)
      .line();
}

std::string startLine(const Pose2& start, const UnknownMembers& of_map) {
  return Members()
      .add("x", metres(start.x))
      .add("y", metres(start.y))
      .add("heading_deg", degrees(start.heading))
      .addKept(of_map, "start")
      .line();
}

/// An array with a line for each item.
template <typename Item>
std::string lines(const std::vector<Item>& items, std::string (*line)(const Item&)) {
  std::vector<std::string> texts;
  texts.reserve(items.size());
  for (const Item& item : items) texts.push_back(line(item));
  return texts.empty() ? "[]" : fmt::format("[\n    {}\n  ]", fmt::join(texts, ",\n    "));
}

}  // namespace

std::string formatMap(const Map& map) {
  Members members;
  members.add("format", "\"handmap\"").add("version", std::to_string(kMapVersion));
  if (!map.name.empty()) members.add("name", quotedJson(map.name));
  if (map.start) members.add("start", startLine(*map.start, map.unknown));
  members.add("uncertainty", uncertaintyMembers(map).addKept(map.unknown, "uncertainty").line());
  members.add("buildings", lines(map.buildings, buildingLine));
  if (!map.landmarks.empty()) members.add("landmarks", lines(map.landmarks, landmarkLine));
  if (!map.route.empty()) members.add("route", points(toMillimetres(map.route)));
  if (!map.underlays.empty()) members.add("underlays", lines(map.underlays, underlayLine));
  if (map.georeference) members.add("georeference", georeferenceLine(*map.georeference));
  if (!map.refinement.empty()) {
    members.add("refinement", parseJson(map.refinement, "refinement").dump());
  }
  return members.addUnknown(withOwnMembers(map), {"start", "uncertainty"}).block();
}

void writeMap(const Map& map, const std::filesystem::path& path) {
  const std::string text = formatMap(map);
  parseMap(text, path.string());  // what could not be read again is not written
  writeFileAtomically(path, text);
}

}  // namespace handmap
