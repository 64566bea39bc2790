#include <algorithm>
#include <cctype>
#include <unordered_map>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/text.h"
#include "core/map/map_limits.h"
#include "core/sketch_study/sketch.h"

namespace handmap {

namespace {

constexpr std::uintmax_t kMostBytes = 64 << 20;
constexpr std::size_t kMostFeatures = 100000;
constexpr Vec2::Scalar kCanvas[] = {850.0, 600.0};  // of SketchMapia, units

/// A polygon or a point of a sketch map.
struct Shape {
  Polygon outline;  ///< one corner: a point
};
using Shapes = std::vector<std::pair<std::string, Shape>>;

/// What a unit along x and y is in pixels of the picture that the file was traced on; 1 without.
Vec2 pixelsPerUnit(const std::filesystem::path& file) {
  // NAME.jpg.geojson was traced on NAME.jpg; basemap.geojson on basemap1.jpg.
  const std::string stem = file.stem().string();
  std::vector<std::filesystem::path> pictures;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(
           file.parent_path().empty() ? "." : file.parent_path(), error)) {
    const std::string ending = entry.path().extension().string();
    if (entry.path().filename().string().starts_with(stem) &&
        (ending == ".jpg" || ending == ".png"))
      pictures.push_back(entry.path());
  }
  if (pictures.empty()) return Vec2::Ones();
  const cv::Mat picture = cv::imread(std::ranges::min(pictures).string());
  if (picture.empty()) return Vec2::Ones();
  return {picture.cols / kCanvas[0], picture.rows / kCanvas[1]};
}

Vec2 pointOf(const JsonValue& json, const Vec2& unit) {
  const std::vector<JsonValue> numbers = json.items(3);
  if (numbers.size() < 2) json.fail("two coordinates");
  const auto coordinate = [&](std::size_t i) {
    return numbers[i].number(-kMaxCoordinate, kMaxCoordinate);
  };
  return unit.cwiseProduct(Vec2(coordinate(0), coordinate(1)));
}

Polygon outlineOf(const JsonValue& rings, const Vec2& unit) {
  const std::vector<JsonValue> all = rings.items(kMostFeatures);
  if (all.empty()) rings.fail("a ring of corners");
  Polygon outline;
  for (const JsonValue& corner : all.front().items(kMaxPolygonVertices)) {
    outline.push_back(pointOf(corner, unit));
  }
  if (outline.size() > 1 && outline.front() == outline.back()) outline.pop_back();
  if (outline.size() < 3) all.front().fail("at least three corners");
  if (signedArea(outline) < 0.0) std::ranges::reverse(outline);
  return outline;
}

/// Polygons and points by the member `key` of their properties; streets are left out.
Shapes readShapes(const std::filesystem::path& path, const std::string& key, double scale) {
  const std::string text = readFile(path, kMostBytes);
  const nlohmann::json json = parseJson(text, path.string());
  const Vec2 unit = scale * pixelsPerUnit(path);
  Shapes shapes;
  for (const JsonValue& feature :
       JsonValue(json, path.string()).at("features").items(kMostFeatures)) {
    const JsonValue geometry = feature.at("geometry");
    const std::string kind = geometry.at("type").text(100);
    if (kind != "Polygon" && kind != "Point") continue;
    const JsonValue coordinates = geometry.at("coordinates");
    const JsonValue id = feature.at("properties").at(key);
    std::string name = id.dump();
    std::erase(name, '"');
    shapes.emplace_back(name, kind == "Point" ? Shape{{pointOf(coordinates, unit)}}
                                              : Shape{outlineOf(coordinates, unit)});
  }
  return shapes;
}

/// What stands for what.
struct Group {
  std::vector<std::string> truth;
  std::vector<std::string> drawn;
  std::string kind;
};

std::vector<std::string> idsIn(const JsonValue& align) {
  std::vector<std::string> ids;
  for (const auto& [key, text] : align.others({})) {
    for (const JsonValue& id : align.at(key).items(kMostFeatures)) {
      ids.push_back(id.dump());
      std::erase(ids.back(), '"');
    }
  }
  return ids;
}

std::vector<Group> readAlignment(const std::filesystem::path& path, const std::string& name) {
  const std::string text = readFile(path, kMostBytes);
  const nlohmann::json json = parseJson(text, path.string());
  const JsonValue groups = JsonValue(json, path.string()).at(name);
  std::vector<Group> all;
  for (const auto& [key, content] : groups.object().others({"checkAlignnum"})) {
    const JsonValue group = groups.at(key);
    all.push_back({idsIn(group.at("BaseAlign")), idsIn(group.at("SketchAlign")),
                   group.textOr("genType", 1000, "")});
  }
  return all;
}

void add(Map& map, const std::string& id, const Shape& shape) {
  if (shape.outline.size() == 1) {
    map.landmarks.push_back({.id = id, .name = {}, .position = shape.outline.front()});
  } else if (signedArea(shape.outline) > kMinPolygonArea) {
    Building building;
    building.id = id;
    building.shape = shape.outline;
    map.buildings.push_back(std::move(building));
  }
}

}  // namespace

Sketch readAlignedSketch(const std::filesystem::path& drawing, const std::filesystem::path& truth,
                         double metres) {
  Sketch sketch{drawing.string(), {}, {}, {}};
  for (const auto& [id, shape] : readShapes(truth, "id", metres)) add(sketch.truth, id, shape);
  std::unordered_map<std::string, std::string> drawn_as;  // of the drawing → of the truth
  for (const Group& group :
       readAlignment(drawing.parent_path() / "alignment.json", drawing.stem().string())) {
    const auto buildings = std::ranges::count_if(
        group.truth, [&](const std::string& id) { return sketch.truth.find(id) != nullptr; });
    if (buildings == 0) continue;
    if (group.truth.size() == 1 && group.drawn.size() == 1) {
      drawn_as[group.drawn.front()] = group.truth.front();
      if (group.kind == "Collapse") ++sketch.generalisation.collapsed;
    } else {
      int& count = group.drawn.size() == 1 ? sketch.generalisation.amalgamated
                                           : sketch.generalisation.abstracted;
      count += static_cast<int>(buildings);
      for (const std::string& id : group.drawn) drawn_as[id] = "";
    }
  }
  for (const auto& [id, shape] : readShapes(drawing, "sid", 1.0)) {
    const auto found = drawn_as.find(id);
    // What stands for several is neither one of them nor something that is not there.
    if (found != drawn_as.end() && found->second.empty()) continue;
    add(sketch.drawing, found == drawn_as.end() ? id : found->second, shape);
  }
  return sketch;
}

}  // namespace handmap
