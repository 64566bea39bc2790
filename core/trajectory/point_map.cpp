#include "core/trajectory/point_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/trajectory/constants.h"

namespace handmap {

using namespace trajectory;

namespace {

int indexOf(double v) { return static_cast<int>(std::floor(v / kCell_m)); }

std::size_t cellOf(int x, int y) {
  return static_cast<std::size_t>((y & (kSide - 1)) * kSide + (x & (kSide - 1)));
}

/// How far a coordinate is outside its cell's row or column.
double outside(double v, int index) {
  const double low = index * kCell_m;
  return std::max({low - v, v - (low + kCell_m), 0.0});
}

bool sameKind(const ScanPoint& a, const ScanPoint& b) {
  if (a.followed() || b.followed()) return std::abs(a.height - b.height) < kNear_m;
  if (a.straight() != b.straight()) return false;
  return !a.straight() || a.normal.dot(b.normal) > 0.5 * std::numbers::sqrt2;
}

}  // namespace

PointMap::PointMap() : cells_(static_cast<std::size_t>(kSide) * kSide) {}

std::vector<PointMap::Entry>& PointMap::cellAt(const Vec2& at) {
  return cells_[cellOf(indexOf(at.x()), indexOf(at.y()))];
}

void PointMap::add(const std::vector<ScanPoint>& points, int scan) {
  for (const ScanPoint& point : points) {
    std::vector<Entry>& cell = cellAt(point.at);
    std::erase_if(cell, [&](const Entry& entry) { return entry.scan < oldest_; });
    const auto same = std::count_if(
        cell.begin(), cell.end(), [&](const Entry& entry) { return sameKind(entry.point, point); });
    if (same < kMostOfAKind) cell.push_back({point, scan});
  }
}

const ScanPoint* PointMap::nearest(const ScanPoint& point, double within_m) const {
  const ScanPoint* best = nullptr;
  double best_square = within_m * within_m;
  const auto search = [&](int x, int y) {
    for (const Entry& entry : cells_[cellOf(x, y)]) {
      const double square = (entry.point.at - point.at).squaredNorm();
      if (square >= best_square || entry.scan < oldest_ || !sameKind(entry.point, point)) continue;
      best = &entry.point;
      best_square = square;
    }
  };
  const int middle_x = indexOf(point.at.x());
  const int middle_y = indexOf(point.at.y());
  search(middle_x, middle_y);
  const int reach = static_cast<int>(std::ceil(within_m / kCell_m));
  for (int y = middle_y - reach; y <= middle_y + reach; ++y) {
    const double aside_y = outside(point.at.y(), y);
    if (aside_y * aside_y >= best_square) continue;
    for (int x = middle_x - reach; x <= middle_x + reach; ++x) {
      const double aside_x = outside(point.at.x(), x);
      if (aside_x * aside_x + aside_y * aside_y >= best_square) continue;
      if (x != middle_x || y != middle_y) search(x, y);
    }
  }
  return best;
}

}  // namespace handmap
