#include "core/perception/range_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

namespace handmap {
namespace {

constexpr float kRangeSigma_m = 0.03F;   ///< of spinning lidars and scanners, by their data sheets
constexpr float kPlanar_m = 0.3F;        ///< heights of a plane scanner that is not quite level
constexpr float kColumn_m = 0.25F;       ///< cells in which vertical extent is measured
constexpr int kMinPoints = 3;            ///< in a column
constexpr float kSpot_m = 0.1F;          ///< a cell of the local map
constexpr std::uint8_t kSpotPoints = 3;  ///< a spot gives no more: near walls are dense enough
constexpr float kEmpty = std::numeric_limits<float>::infinity();
constexpr float kStep_m = 0.4F;  ///< along a ray, less than the cells of what it passes over

std::vector<RangePoint> inRange(const std::vector<RangePoint>& points, float min, float max) {
  std::vector<RangePoint> kept;
  kept.reserve(points.size());
  std::copy_if(points.begin(), points.end(), std::back_inserter(kept), [=](const RangePoint& p) {
    const float range = std::hypot(p.x, p.y);
    return range >= min && range <= max && std::isfinite(p.z) && p.w > 0.0F;
  });
  return kept;
}

WallPoint wallPoint(const RangePoint& p) { return {p.x, p.y, kRangeSigma_m, std::min(p.w, 1.0F)}; }

}  // namespace

bool isPlanar(const std::vector<RangePoint>& points) {
  const auto [low, high] =
      std::minmax_element(points.begin(), points.end(),
                          [](const RangePoint& a, const RangePoint& b) { return a.z < b.z; });
  return points.empty() || high->z - low->z <= kPlanar_m;
}

bool givesOneReturnADirection(const std::vector<RangePoint>& points) {
  constexpr std::size_t kDirections = 360;  // wider than the steps of any scanner
  constexpr double kMost = 2.5;  // points a direction that has any; a column of a wall has more
  if (isPlanar(points)) return true;
  std::array<bool, kDirections> any{};
  for (const RangePoint& p : points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
    const double share =
        (std::atan2(static_cast<double>(p.y), static_cast<double>(p.x)) + kPi) / (2.0 * kPi);
    any[std::min(static_cast<std::size_t>(share * kDirections), kDirections - 1)] = true;
  }
  const auto directions = static_cast<double>(std::count(any.begin(), any.end(), true));
  return static_cast<double>(points.size()) <= kMost * directions;
}

RangeWalls::RangeWalls(double range_limit_m, const WallFilter& filter)
    : range_limit_m_(static_cast<float>(range_limit_m)),
      filter_(filter),
      cells_(range_limit_m_, kColumn_m),
      low_things_(filter.min_height_m, filter.leastTop(), range_limit_m) {}

std::vector<WallPoint> RangeWalls::operator()(const std::vector<RangePoint>& points,
                                              const Pose2& odometry) {
  const std::vector<RangePoint> seen =
      inRange(points, static_cast<float>(filter_.min_range_m), range_limit_m_);
  if (!givesOneReturnADirection(seen)) return standing(seen, odometry);
  std::vector<WallPoint> walls(seen.size());
  std::transform(seen.begin(), seen.end(), walls.begin(), wallPoint);
  return walls;
}

std::vector<WallPoint> RangeWalls::standing(const std::vector<RangePoint>& points,
                                            const Pose2& odometry) {
  columns_.assign(cells_.count(), {kEmpty, -kEmpty, 0});
  const GroundHeight ground(points, range_limit_m_);
  for (const RangePoint& p : points) add(p, ground, odometry);
  const PlaneCells spots(range_limit_m_, kSpot_m);
  std::vector<std::uint8_t> taken(spots.count(), 0);
  std::vector<WallPoint> walls;
  for (const RangePoint& p : points) {
    const std::size_t cell = cells_.of(p.x, p.y);
    if (!isWall(columns_[cell], odometry.toOuter(cells_.centreOf(cell)))) continue;
    std::uint8_t& votes = taken[spots.of(p.x, p.y)];
    if (votes == kSpotPoints) continue;
    ++votes;
    walls.push_back(wallPoint(p));
  }
  return walls;
}

void RangeWalls::add(const RangePoint& p, const GroundHeight& ground, const Pose2& odometry) {
  const float height = p.z - ground.at(p.x, p.y);
  if (height <= static_cast<float>(filter_.max_height_m)) {
    Column& column = columns_[cells_.of(p.x, p.y)];
    column.low = std::min(column.low, height);
    column.high = std::max(column.high, height);
    ++column.count;
  }
  low_things_.addStop(odometry.toOuter({p.x, p.y}), height);
  const auto sensor = static_cast<float>(filter_.sensor_height_m);
  if (p.z <= sensor) return;
  const float range = std::hypot(p.x, p.y);
  const float lowest = static_cast<float>(low_things_.low()) - sensor;
  const float highest = static_cast<float>(low_things_.high()) - sensor;
  const float rise = (p.z - sensor) / range;
  const float last = std::min(range - 2.0F * kStep_m, highest / rise);
  for (float at = std::max(lowest / rise, kStep_m); at < last; at += kStep_m) {
    const float x = p.x * at / range;
    const float y = p.y * at / range;
    low_things_.addPass(odometry.toOuter({x, y}), sensor + at * rise - ground.at(x, y));
  }
}

/// A spinning lidar looks hardly upwards: 10 m away it ends 2.6 m above ground. So a wall need only
/// reach above min_height, its extent counting from wherever it is first seen, as long as nothing
/// was seen over it.
bool RangeWalls::isWall(const Column& column, const Vec2& at) const {
  return column.count >= kMinPoints && column.high >= static_cast<float>(filter_.min_height_m) &&
         column.high - column.low >= static_cast<float>(filter_.min_extent_m) &&
         !low_things_.isLow(at);
}

}  // namespace handmap
