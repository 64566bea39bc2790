// The noise of a sensor's ranges, as neighbouring returns show it.
#pragma once

#include <array>
#include <vector>

#include "core/geometry/pose2.h"

namespace handmap {

/// Of a Gaussian: σ over the median of what is off.
inline constexpr double kMedianToSigma = 1.48;

/// Collects how far each return is off the line between its two neighbours in bearing; the median
/// of many is noise, since most neighbours are on one surface.
class ScanNoise {
 public:
  /// Returns of one observation, robot frame, metres, in any order.
  void add(const std::vector<Vec2>& returns);

  /// One σ, metres. Before enough was seen, that of a common laser.
  double sigma(double range_m) const;

 private:
  static constexpr std::size_t kRanges = 8;
  static constexpr std::size_t kSteps = 60;
  using Histogram = std::array<int, kSteps>;
  static double median(const Histogram& histogram, int count);

  std::array<Histogram, kRanges> deviations_{};
  std::array<int, kRanges> counts_{};
};

}  // namespace handmap
