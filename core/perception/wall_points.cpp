#include "core/perception/wall_points.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

#include "core/perception/ground_height.h"

namespace handmap {
namespace {

constexpr float kSigma_m = 0.03F;
constexpr float kPlanar_m = 0.3F;   ///< a scan with all heights within this is planar
constexpr float kColumn_m = 0.25F;  ///< cells in which vertical extent is measured
constexpr int kMinPoints = 3;       ///< in a column
constexpr float kSpot_m = 0.1F;
constexpr std::uint8_t kSpotPoints = 3;  ///< a spot gives no more: near walls are dense enough

struct Column {
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();
  int count = 0;
};

std::vector<RangePoint> inRange(const std::vector<RangePoint>& points, float min, float max) {
  std::vector<RangePoint> kept;
  kept.reserve(points.size());
  std::copy_if(points.begin(), points.end(), std::back_inserter(kept), [=](const RangePoint& p) {
    const float range = std::hypot(p.x, p.y);
    return range >= min && range <= max && std::isfinite(p.z) && p.w > 0.0F;
  });
  return kept;
}

bool isPlanar(const std::vector<RangePoint>& points) {
  const auto [low, high] =
      std::minmax_element(points.begin(), points.end(),
                          [](const RangePoint& a, const RangePoint& b) { return a.z < b.z; });
  return high->z - low->z <= kPlanar_m;
}

WallPoint wallPoint(const RangePoint& p) { return {p.x, p.y, kSigma_m, std::min(p.w, 1.0F)}; }

/// A spinning lidar looks hardly upwards: 10 m away it ends 2.6 m above ground. So a wall need only
/// reach above min_height; its extent counts from wherever it is first seen.
bool isWall(const Column& column, const WallFilter& filter) {
  return column.count >= kMinPoints && column.high >= static_cast<float>(filter.min_height_m) &&
         column.high - column.low >= static_cast<float>(filter.min_extent_m);
}

std::vector<WallPoint> standingPoints(const std::vector<RangePoint>& points, float range_limit,
                                      const WallFilter& filter) {
  const GroundHeight ground(points, range_limit);
  const PlaneCells cells(range_limit, kColumn_m);
  std::vector<Column> columns(cells.count());
  for (const RangePoint& p : points) {
    const float height = p.z - ground.at(p.x, p.y);
    if (height > static_cast<float>(filter.max_height_m)) continue;
    Column& column = columns[cells.of(p.x, p.y)];
    column.low = std::min(column.low, height);
    column.high = std::max(column.high, height);
    ++column.count;
  }
  const PlaneCells spots(range_limit, kSpot_m);
  std::vector<std::uint8_t> taken(spots.count(), 0);
  std::vector<WallPoint> walls;
  for (const RangePoint& p : points) {
    if (!isWall(columns[cells.of(p.x, p.y)], filter)) continue;
    std::uint8_t& votes = taken[spots.of(p.x, p.y)];
    if (votes == kSpotPoints) continue;
    ++votes;
    walls.push_back(wallPoint(p));
  }
  return walls;
}

}  // namespace

std::vector<WallPoint> wallPoints(const std::vector<RangePoint>& points, double range_limit_m,
                                  const WallFilter& filter) {
  const auto range_limit = static_cast<float>(range_limit_m);
  const std::vector<RangePoint> seen =
      inRange(points, static_cast<float>(filter.min_range_m), range_limit);
  if (seen.empty()) return {};
  if (!isPlanar(seen)) return standingPoints(seen, range_limit, filter);
  std::vector<WallPoint> walls(seen.size());
  std::transform(seen.begin(), seen.end(), walls.begin(), wallPoint);
  return walls;
}

}  // namespace handmap
