#include "core/perception/low_things.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/perception/constants.h"

namespace handmap {

using namespace perception;

namespace {

void count(std::uint16_t& counter) {
  if (counter < std::numeric_limits<std::uint16_t>::max()) ++counter;
}

}  // namespace

LowThings::LowThings(double low_m, double high_m, double range_m)
    : low_(low_m),
      high_(high_m),
      side_(static_cast<std::int64_t>(
          std::bit_ceil(static_cast<std::uint64_t>(3.0 * range_m / kLowCell_m) + 1U))),
      cells_(static_cast<std::size_t>(side_ * side_)) {}

LowThings::Place LowThings::placeOf(const Vec2& at) {
  return {std::llround(std::floor(at.x() / kLowCell_m)),
          std::llround(std::floor(at.y() / kLowCell_m))};
}

std::size_t LowThings::indexOf(const Place& place) const {
  const std::int64_t mask = side_ - 1;
  return static_cast<std::size_t>((place.row & mask) * side_ + (place.column & mask));
}

LowThings::Cell& LowThings::ownCell(const Vec2& at) {
  const Place place = placeOf(at);
  Cell& cell = cells_[indexOf(place)];
  if (cell.place != place) cell = {place, {}, {}};
  return cell;
}

std::size_t LowThings::binOf(double height_m) const {
  const double share = std::min((height_m - low_) / (high_ - low_), 1.0);
  return static_cast<std::size_t>(share * kLowBins);
}

void LowThings::addStop(const Vec2& at, double height_m) {
  if (height_m >= low_) count(ownCell(at).stops[binOf(height_m)]);
}

void LowThings::addPass(const Vec2& at, double height_m) {
  if (height_m >= low_ && height_m < high_) count(ownCell(at).passes[binOf(height_m)]);
}

bool LowThings::isLow(const Vec2& at) const {
  const Place place = placeOf(at);
  const Cell& cell = cells_[indexOf(place)];
  if (cell.place != place) return false;
  int stops = cell.stops[kLowBins];
  int passes = 0;
  for (std::size_t bin = kLowBins; bin-- > 0;) {
    stops += cell.stops[bin];
    passes += cell.passes[bin];
    if (passes >= kPasses && passes > kPasses * stops) return true;
  }
  return false;
}

}  // namespace handmap
