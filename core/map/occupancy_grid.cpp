#include "core/map/occupancy_grid.h"

#include <algorithm>
#include <cmath>

namespace handmap {

namespace {

constexpr double kMargin_m = 5.0;  // at least, and the corners are multiples of it
constexpr double kMostCells = 1e6;

/// Cells along a row whose centre is inside: between the 1st and 2nd, 3rd and 4th … crossing.
void fillRow(const Polygon& polygon, double y, OccupancyGrid& grid, std::size_t row_begin) {
  std::vector<double> crossings;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % polygon.size()];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
  std::sort(crossings.begin(), crossings.end());
  const auto column = [&](double x) {
    const double cell = std::ceil((x - grid.origin.x()) / grid.cell_m - 0.5);
    return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(grid.columns)));
  };
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    for (std::size_t c = column(crossings[i]); c < column(crossings[i + 1]); ++c) {
      grid.cells[row_begin + c] = 1;
    }
  }
}

}  // namespace

OccupancyGrid occupancyOf(const Map& map, double cell_m) {
  std::vector<Polygon> footprints;
  Vec2 low = map.start ? map.start->position() : Vec2::Zero();
  Vec2 high = low;
  for (const Building& building : map.buildings) {
    footprints.push_back(building.footprint());
    const Bounds bounds = boundsOf(footprints.back());
    low = low.cwiseMin(bounds.low);
    high = high.cwiseMax(bounds.high);
  }
  const auto outward = [](const Vec2& corner, double side) {
    return Vec2((kMargin_m * side * ((side * corner / kMargin_m).array() + 1.0).ceil()).matrix());
  };
  OccupancyGrid grid;
  grid.origin = outward(low, -1.0);
  const Vec2 size = outward(high, 1.0) - grid.origin;
  grid.cell_m = std::max(cell_m, std::sqrt(size.prod() / kMostCells));
  grid.columns = static_cast<std::size_t>(std::ceil(size.x() / grid.cell_m));
  grid.rows = static_cast<std::size_t>(std::ceil(size.y() / grid.cell_m));
  grid.cells.resize(grid.columns * grid.rows);
  for (const Polygon& polygon : footprints) {
    const Bounds bounds = boundsOf(polygon);
    const double first = std::floor((bounds.low.y() - grid.origin.y()) / grid.cell_m);
    for (auto r = static_cast<std::size_t>(std::max(first, 0.0)); r < grid.rows; ++r) {
      const double y = grid.origin.y() + (static_cast<double>(r) + 0.5) * grid.cell_m;
      if (y > bounds.high.y()) break;
      fillRow(polygon, y, grid, r * grid.columns);
    }
  }
  return grid;
}

}  // namespace handmap
