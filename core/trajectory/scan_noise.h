// The noise of a sensor's ranges, as neighbouring returns show it.
#pragma once

#include <array>
#include <vector>

#include "core/geometry/pose2.h"
#include "core/trajectory/constants.h"

namespace handmap {

/// Collects how far each return is off the line between its two neighbours in bearing. The quarter
/// that is off least tells the noise: among leaves, and where rays are few, half of the neighbours
/// are on no common surface.
class ScanNoise {
 public:
  /// Returns of one observation, robot frame, metres, in any order.
  void add(const std::vector<Vec2>& returns);

  /// One σ, metres. Before enough was seen, that of a common laser.
  double sigma(double range_m) const;
  /// Whether enough was seen that far.
  bool knows(double range_m) const { return !told_.empty() && told_.back().range_m >= range_m; }

 private:
  using Histogram = std::array<int, trajectory::kSteps>;
  static double sigmaOf(const Histogram& histogram, int count);
  void tell();

  std::array<Histogram, trajectory::kRanges> deviations_{};
  std::array<int, trajectory::kRanges> counts_{};
  struct Told {
    double range_m;
    double sigma_m;
  };
  std::vector<Told> told_;  ///< by range
};

}  // namespace handmap
