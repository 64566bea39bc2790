// The drawing that a person made on paper, as a map.
#pragma once

#include <string>
#include <vector>

#include "core/map/map.h"
#include "core/paper/trace.h"

namespace handmap {

/// Where a page lies on the map, upright.
struct PagePlace {
  Vec2 corner = Vec2::Zero();  ///< its lower left, metres
  double metres_per_pixel = 0.1;
};

PagePlace placeOf(const Page& page, const Sheet& sheet);
/// A map is printed on the sheet, and nothing tells where on it the sheet lies.
bool isPlaceUnread(const Trace& trace);
/// So large that the page is so wide, its middle at the origin.
PagePlace placeOfPage(const Page& page, double width_m);
/// The same where these shapes of the trace are, all together, so wide; as the page where there is
/// none.
PagePlace placeOfDrawing(const Trace& trace, const std::vector<std::size_t>& shapes,
                         double width_m);
/// Those that are surely buildings.
std::vector<std::size_t> sureShapes(const Trace& trace);

/// Without id; with the handwriting in it.
Building buildingOf(const TracedShape& shape, const Ink& ink, const PagePlace& place);
/// `image`: its path, see Underlay.
Underlay underlayOf(const Page& page, const PagePlace& place, const std::string& image);
/// Of the shapes that are surely buildings, B1, B2 … from left to right, off by as much as people's
/// drawings are.
Map mapOf(const Trace& trace, const PagePlace& place);
/// What a drawing on paper is off by: as people's drawings are.
Uncertainty uncertaintyOnPaper(const Map& map);
/// `drawn` over what was printed: a shape over a building is its new outline, all else is new.
Map drawnOver(Map printed, const Map& drawn);
/// The building of `printed` that this one is drawn over; nullptr: none.
const Building* buildingUnder(const Map& printed, const Building& drawn);

}  // namespace handmap
