// What scanners give as ranges along directions, and as points packed in bytes, made into points.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/recording/observation.h"

namespace handmap {

inline constexpr double kFarthestPoint_m = 1e4;  ///< no scanner sees as far

/// As sensor_msgs/LaserScan has it: metres, radians, counter-clockwise.
struct LaserScan {
  double first_rad = 0.0;
  double step_rad = 0.0;
  double nearest_m = 0.0;
  double farthest_m = 0.0;
  std::vector<double> ranges;
};

/// Nothing is known beyond it.
float reachOf(const LaserScan& scan);
/// In the frame of the scanner, w = 1, z = 0. Where nothing came back there is no point; what is no
/// number, or nearer than the least range, was not measured.
std::vector<RangePoint> pointsOf(const LaserScan& scan);

/// One coordinate of a packed point.
struct PackedField {
  std::size_t offset = 0;
  bool is_double = false;
};

/// As sensor_msgs/PointCloud2 has it; `data` holds row_bytes·(rows − 1) + point_bytes·columns.
struct PackedPoints {
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::size_t point_bytes = 0;  ///< holds all three fields
  std::size_t row_bytes = 0;
  bool is_big_endian = false;
  PackedField x, y, z;
  std::string_view data;
};

/// In the sensor's frame, w = 1. What is not finite or farther than 10 km is left out.
std::vector<RangePoint> pointsOf(const PackedPoints& packed);

}  // namespace handmap
