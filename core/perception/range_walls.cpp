#include "core/perception/range_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

#include "core/perception/constants.h"

namespace handmap {

using namespace perception;

namespace {

std::vector<RangePoint> inRange(const std::vector<RangePoint>& points, float min, float max) {
  std::vector<RangePoint> kept;
  kept.reserve(points.size());
  std::copy_if(points.begin(), points.end(), std::back_inserter(kept), [=](const RangePoint& p) {
    const float range = std::hypot(p.x, p.y);
    return range >= min && range <= max && std::isfinite(p.z) && p.w > 0.0F;
  });
  return kept;
}

WallPoint wallPoint(const RangePoint& p) {
  return {p.x, p.y, static_cast<float>(kLaserSigma_m), std::min(p.w, 1.0F)};
}

}  // namespace

bool isPlanar(const std::vector<RangePoint>& points) {
  const auto [low, high] =
      std::minmax_element(points.begin(), points.end(),
                          [](const RangePoint& a, const RangePoint& b) { return a.z < b.z; });
  return points.empty() || high->z - low->z <= kLevel_m;
}

bool givesOneReturnADirection(const std::vector<RangePoint>& points) {
  const auto count = static_cast<double>(points.size());
  if (isPlanar(points)) return true;
  if (count > kMostADirection * static_cast<double>(kDegrees)) return false;
  std::array<bool, kDegrees> any{};
  for (const RangePoint& p : points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
    const double share =
        (std::atan2(static_cast<double>(p.y), static_cast<double>(p.x)) + kPi) / (2.0 * kPi);
    any[std::min(static_cast<std::size_t>(share * kDegrees), kDegrees - 1)] = true;
  }
  const auto directions = static_cast<double>(std::count(any.begin(), any.end(), true));
  return count <= kMostADirection * directions;
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
  columns_.assign(cells_.count(), {kUnknownHeight_m, -kUnknownHeight_m, 0});
  const GroundHeight ground(points, range_limit_m_);
  const ToOuter outer(odometry);
  for (const RangePoint& p : points) add(p, ground, outer);
  const PlaneCells spots(range_limit_m_, static_cast<float>(kMapCell_m));
  std::vector<std::uint8_t> taken(spots.count(), 0);
  std::vector<WallPoint> walls;
  for (const RangePoint& p : points) {
    const std::size_t cell = cells_.of(p.x, p.y);
    if (!isWall(columns_[cell], outer(cells_.centreOf(cell)))) continue;
    std::uint8_t& votes = taken[spots.of(p.x, p.y)];
    if (votes >= kSaturation) continue;
    ++votes;
    walls.push_back(wallPoint(p));
  }
  return walls;
}

void RangeWalls::add(const RangePoint& p, const GroundHeight& ground, const ToOuter& outer) {
  const float height = p.z - ground.at(p.x, p.y);
  if (height <= static_cast<float>(filter_.max_height_m)) {
    Column& column = columns_[cells_.of(p.x, p.y)];
    column.low = std::min(column.low, height);
    column.high = std::max(column.high, height);
    ++column.count;
  }
  low_things_.addStop(outer({p.x, p.y}), height);
  const auto sensor = static_cast<float>(filter_.sensor_height_m);
  if (p.z <= sensor) return;
  const float range = std::hypot(p.x, p.y);
  const float lowest = static_cast<float>(low_things_.low()) - sensor;
  const float highest = static_cast<float>(low_things_.high()) - sensor;
  const float rise = (p.z - sensor) / range;
  const float last = std::min(range - 2.0F * kPassStep_m, highest / rise);
  for (float at = std::max(lowest / rise, kPassStep_m); at < last; at += kPassStep_m) {
    const float x = p.x * at / range;
    const float y = p.y * at / range;
    low_things_.addPass(outer({x, y}), sensor + at * rise - ground.at(x, y));
  }
}

/// A spinning lidar looks hardly upwards: 10 m away it ends 2.6 m above ground. So a wall need only
/// reach above min_height, its extent counting from wherever it is first seen, as long as nothing
/// was seen over it.
bool RangeWalls::isWall(const Column& column, const Vec2& at) const {
  return column.count >= static_cast<int>(kLeastPoints) &&
         column.high >= static_cast<float>(filter_.min_height_m) &&
         column.high - column.low >= static_cast<float>(filter_.min_extent_m) &&
         !low_things_.isLow(at);
}

}  // namespace handmap
