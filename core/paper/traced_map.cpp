#include "core/paper/traced_map.h"

#include <algorithm>
#include <array>
#include <unordered_set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/map/certainty.h"
#include "core/simulation/drawn_by_people.h"

namespace handmap {

namespace {

constexpr double kSameBuilding = 0.5;  // intersection over union
constexpr double kOpacity = 0.6;

Polygon moved(Polygon outline, const PagePlace& place) {
  for (Vec2& corner : outline) corner = place.corner + place.metres_per_pixel * corner;
  return outline;
}

}  // namespace

PagePlace placeOf(const Page& page, const Sheet& sheet) {
  return {sheet.corner, sheet.metres_per_mm() * kSheetWidth_mm / page.image.cols};
}

PagePlace placeOfPage(const Page& page, double width_m) {
  const double metres_per_pixel = width_m / std::max(1, page.image.cols);
  return {-0.5 * metres_per_pixel * Vec2(page.image.cols, page.image.rows), metres_per_pixel};
}

PagePlace placeOfDrawing(const Trace& trace, double width_m) {
  double left = trace.page.image.cols, right = 0.0;
  for (const TracedShape& shape : trace.shapes) {
    if (shape.confidence < kSureOfShape) continue;
    const Bounds bounds = boundsOf(shape.outline);
    left = std::min(left, bounds.low.x());
    right = std::max(right, bounds.high.x());
  }
  const double share = right > left ? (right - left) / trace.page.image.cols : 1.0;
  return placeOfPage(trace.page, width_m / share);
}

Building buildingOf(const TracedShape& shape, const PagePlace& place) {
  Building building;
  building.shape = moved(shape.outline, place);
  if (shape.rectangle) {
    Rectangle box = *shape.rectangle;
    box.centre = place.corner + place.metres_per_pixel * box.centre;
    box.width *= place.metres_per_pixel;
    box.depth *= place.metres_per_pixel;
    building.shape = box;
  }
  if (shape.writing) {
    const cv::Rect& box = *shape.writing;
    building.unknown[kWritingKey] =
        fmt::format("[{}, {}, {}, {}]", box.x, box.y, box.width, box.height);
  }
  return building;
}

Underlay underlayOf(const Page& page, const PagePlace& place, const std::string& image) {
  Underlay underlay;
  underlay.image = image;
  underlay.x = place.corner.x();
  underlay.y = place.corner.y() + place.metres_per_pixel * page.image.rows;
  underlay.metres_per_pixel = place.metres_per_pixel;
  underlay.opacity = kOpacity;
  underlay.unknown[kPaperKey] = "true";
  return underlay;
}

Map mapOf(const Trace& trace, const PagePlace& place) {
  Map map;
  for (const TracedShape& shape : trace.shapes) {
    if (shape.confidence < kSureOfShape) continue;
    map.buildings.push_back(buildingOf(shape, place));
    map.buildings.back().id = fmt::format("B{}", map.buildings.size());
  }
  if (map.buildings.empty()) return map;
  map.uncertainty = uncertaintyOfPeople(map);
  // Of one building, or of some at one place, the extent tells nothing.
  map.uncertainty.position = std::max(map.uncertainty.position, map.uncertainty.size);
  return map;
}

Map drawnOver(Map printed, const Map& drawn) {
  std::unordered_set<std::string> taken;
  for (const Building& building : printed.buildings) taken.insert(building.id);
  const std::size_t before = printed.buildings.size();
  std::size_t number = 0;
  for (Building building : drawn.buildings) {
    const Polygon outline = building.footprint();
    const auto end = printed.buildings.begin() + static_cast<std::ptrdiff_t>(before);
    const auto under = std::find_if(printed.buildings.begin(), end, [&](const Building& known) {
      return intersectionOverUnion(known.footprint(), outline) >= kSameBuilding;
    });
    if (under != end) {
      under->shape = building.shape;
      forgetCertainty(*under);
      continue;
    }
    do building.id = fmt::format("B{}", ++number);
    while (!taken.insert(building.id).second);
    printed.buildings.push_back(std::move(building));
  }
  printed.underlays.insert(printed.underlays.end(), drawn.underlays.begin(), drawn.underlays.end());
  return printed;
}

std::optional<cv::Rect> writingOf(const Building& building) {
  const auto text = building.unknown.find(kWritingKey);
  if (text == building.unknown.end()) return std::nullopt;
  const nlohmann::json box = nlohmann::json::parse(text->second, nullptr, false);
  if (!box.is_array() || box.size() != 4) return std::nullopt;
  std::array<int, 4> numbers{};
  for (std::size_t i = 0; i < 4; ++i) {
    if (!box[i].is_number_integer()) return std::nullopt;
    const auto number = box[i].get<std::int64_t>();
    if (number < 0 || number > kPageSide_px) return std::nullopt;
    numbers[i] = static_cast<int>(number);
  }
  return cv::Rect(numbers[0], numbers[1], numbers[2], numbers[3]);
}

}  // namespace handmap
