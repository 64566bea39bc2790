// The noise of a sensor's ranges, as neighbouring returns show it.
#pragma once

#include <array>
#include <vector>

#include "core/geometry/pose2.h"
#include "core/trajectory/constants.h"

namespace handmap {

/// Collects how far each return is off the line between its two neighbours in bearing; the median
/// of many is noise, since most neighbours are on one surface.
class ScanNoise {
 public:
  /// Returns of one observation, robot frame, metres, in any order.
  void add(const std::vector<Vec2>& returns);

  /// One σ, metres. Before enough was seen, that of a common laser.
  double sigma(double range_m) const;

 private:
  using Histogram = std::array<int, trajectory::kSteps>;
  static double median(const Histogram& histogram, int count);

  std::array<Histogram, trajectory::kRanges> deviations_{};
  std::array<int, trajectory::kRanges> counts_{};
};

}  // namespace handmap
