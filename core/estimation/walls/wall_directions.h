// The directions that walls have, as the returns themselves show them.
#pragma once

#include <array>
#include <vector>

#include "core/estimation/walls/frame.h"

namespace handmap {

/// The least angle between two directions that are looked for apart, radians. Walls are found up to
/// half as much off a direction. Choice: the tilts of the detection reach 4.5°.
inline constexpr double kDirectionsApart = toRadians(9.0);

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
  /// The directions that many votes agree on, in [0, π/2), at least kDirectionsApart / 2 apart.
  std::vector<double> peaks() const;

 private:
  static constexpr std::size_t kBins = 60;
  static constexpr double kBin = kPi / 2.0 / static_cast<double>(kBins);

  double around(std::size_t bin) const;

  std::array<double, kBins> votes_{};  ///< metres of wall
};

}  // namespace handmap
