#include "core/recording/laser_scan.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace handmap {

namespace {

template <typename Real>
double realAt(const char* at, bool big) {
  char raw[sizeof(Real)];
  std::memcpy(raw, at, sizeof(Real));
  if (big) std::reverse(raw, raw + sizeof(Real));
  Real value;
  std::memcpy(&value, raw, sizeof(Real));
  return static_cast<double>(value);
}

double valueOf(const PackedField& field, const char* point, bool big) {
  return field.is_double ? realAt<double>(point + field.offset, big)
                         : realAt<float>(point + field.offset, big);
}

}  // namespace

// In the precision of the ranges: the end of the range itself, or 0, is what many drivers give
// where nothing came back. As an infinite range (REP 117) it is told by no point.
float reachOf(const LaserScan& scan) {
  return static_cast<float>(std::min(scan.farthest_m, kFarthestPoint_m));
}

std::vector<RangePoint> pointsOf(const LaserScan& scan) {
  const float end = reachOf(scan);
  std::vector<RangePoint> points;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const auto rounded = static_cast<float>(scan.ranges[i]);
    if (rounded == 0.0F || rounded >= end) continue;  // nothing came back
    const double bearing = scan.first_rad + scan.step_rad * static_cast<double>(i);
    if (!(rounded >= static_cast<float>(scan.nearest_m))) {
      points.push_back(notMeasured(bearing, 0.0F));
      continue;
    }
    const Vec2 point = scan.ranges[i] * unitVector(bearing);
    points.push_back({static_cast<float>(point.x()), static_cast<float>(point.y()), 0.0F, 1.0F});
  }
  return points;
}

std::vector<RangePoint> pointsOf(const PackedPoints& packed) {
  const bool big = packed.is_big_endian;
  const auto is_near = [](double value) { return std::abs(value) <= kFarthestPoint_m; };
  std::vector<RangePoint> points;
  points.reserve(std::min(packed.columns * packed.rows, packed.data.size()));
  for (std::size_t row = 0; row < packed.rows; ++row) {
    for (std::size_t column = 0; column < packed.columns; ++column) {
      const char* point = packed.data.data() + row * packed.row_bytes + column * packed.point_bytes;
      const double x = valueOf(packed.x, point, big);
      const double y = valueOf(packed.y, point, big);
      const double z = valueOf(packed.z, point, big);
      if (!is_near(x) || !is_near(y) || !is_near(z)) continue;
      points.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z), 1.0F});
    }
  }
  return points;
}

}  // namespace handmap
