#include "core/paper/traced_map.h"

#include <algorithm>
#include <unordered_set>

#include <fmt/format.h>

#include "core/map/certainty.h"
#include "core/paper/handwriting.h"
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

bool isPlaceUnread(const Trace& trace) { return trace.page.sheet && !sheetOf(*trace.page.sheet); }

PagePlace placeOfPage(const Page& page, double width_m) {
  const double metres_per_pixel = width_m / std::max(1, page.image.cols);
  return {-0.5 * metres_per_pixel * Vec2(page.image.cols, page.image.rows), metres_per_pixel};
}

PagePlace placeOfDrawing(const Trace& trace, const std::vector<std::size_t>& shapes,
                         double width_m) {
  double left = trace.page.image.cols, right = 0.0;
  for (const std::size_t shape : shapes) {
    const Bounds bounds = boundsOf(trace.shapes[shape].outline);
    left = std::min(left, bounds.low.x());
    right = std::max(right, bounds.high.x());
  }
  const double share = right > left ? (right - left) / trace.page.image.cols : 1.0;
  return placeOfPage(trace.page, width_m / share);
}

std::vector<std::size_t> sureShapes(const Trace& trace) {
  std::vector<std::size_t> sure;
  for (std::size_t i = 0; i < trace.shapes.size(); ++i)
    if (trace.shapes[i].confidence >= kSureOfShape) sure.push_back(i);
  return sure;
}

Building buildingOf(const TracedShape& shape, const Ink& ink, const PagePlace& place) {
  Building building;
  building.shape = moved(shape.outline, place);
  if (shape.rectangle) {
    Rectangle box = *shape.rectangle;
    box.centre = place.corner + place.metres_per_pixel * box.centre;
    box.width *= place.metres_per_pixel;
    box.depth *= place.metres_per_pixel;
    building.shape = box;
  }
  if (shape.writing) building.unknown[kWritingKey] = writingText(ink.mask(*shape.writing));
  return building;
}

Underlay underlayOf(const Page& page, const PagePlace& place, const std::string& image) {
  Underlay underlay;
  underlay.image = image;
  underlay.x = place.corner.x();
  underlay.y = place.corner.y() + place.metres_per_pixel * page.image.rows;
  if (page.sheet) {  // no whole number of pixels: its corner is to be told from this
    underlay.y = place.corner.y() +
                 place.metres_per_pixel * page.image.cols * kSheetHeight_mm / kSheetWidth_mm;
  }
  underlay.metres_per_pixel = place.metres_per_pixel;
  underlay.opacity = kOpacity;
  underlay.unknown[kPaperKey] =
      page.sheet ? fmt::format(R"({{"square_m": {}}})", page.sheet->square_m) : "true";
  return underlay;
}

Map mapOf(const Trace& trace, const PagePlace& place) {
  Map map;
  for (const std::size_t shape : sureShapes(trace)) {
    map.buildings.push_back(buildingOf(trace.shapes[shape], trace.ink, place));
    map.buildings.back().id = fmt::format("B{}", map.buildings.size());
  }
  if (!map.buildings.empty()) map.uncertainty = uncertaintyOnPaper(map);
  return map;
}

Uncertainty uncertaintyOnPaper(const Map& map) {
  Uncertainty uncertainty = uncertaintyOfPeople(map);
  // Of one building, or of some at one place, the extent tells nothing.
  uncertainty.position = std::max(uncertainty.position, uncertainty.size);
  return uncertainty;
}

const Building* buildingUnder(const Map& printed, const Building& drawn) {
  const Polygon outline = drawn.footprint();
  const auto under = std::ranges::find_if(printed.buildings, [&](const Building& known) {
    return intersectionOverUnion(known.footprint(), outline) >= kSameBuilding;
  });
  return under == printed.buildings.end() ? nullptr : &*under;
}

Map drawnOver(Map printed, const Map& drawn) {
  const Map before = printed;
  std::unordered_set<std::string> taken;
  for (const Building& building : before.buildings) taken.insert(building.id);
  std::size_t number = 0;
  for (Building building : drawn.buildings) {
    if (const Building* under = buildingUnder(before, building)) {
      Building& changed =
          printed.buildings[static_cast<std::size_t>(under - before.buildings.data())];
      changed.shape = building.shape;
      forgetCertainty(changed);
      continue;
    }
    do building.id = fmt::format("B{}", ++number);
    while (!taken.insert(building.id).second);
    printed.buildings.push_back(std::move(building));
  }
  return printed;
}

}  // namespace handmap
