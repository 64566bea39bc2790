// The directions that walls have, as the returns themselves show them.
#pragma once

#include <array>
#include <vector>

#include "core/estimation/walls/frame.h"

namespace handmap {

/// The angle from one direction to the other, both modulo a quarter turn; in ±π/4.
inline double directionError(double heading, double other) {
  return std::remainder(heading - other, kPi / 2.0);
}

/// Votes for directions, modulo a quarter turn, by the length of the straight pieces in the
/// returns. A little is forgotten with each frame.
class WallDirections {
 public:
  /// What a frame shows from `pose`.
  void add(const Frame& frame, const Pose2& pose, const SensorModel& sensor);
  /// The directions that many votes agree on, in [0, π/2), at least walls::kDirectionsApart / 2
  /// apart.
  std::vector<double> peaks() const;

 private:
  double around(std::size_t bin) const;

  std::array<double, walls::kBins> votes_{};  ///< metres of wall
};

}  // namespace handmap
