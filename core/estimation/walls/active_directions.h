// Which directions the evidence looks for walls in.
#pragma once

#include <vector>

#include "core/estimation/walls/wall_directions.h"
#include "core/estimation/walls/wall_evidence.h"

namespace handmap {

/// Follows what is drawn near the robot and what the returns show: a direction is taken up when it
/// is wanted and given up when it has not been for a while.
class ActiveDirections {
 public:
  /// Votes of the last of the `held` frames; then brings `evidence`, which holds these, up to date.
  void update(std::span<const double> drawn, std::span<const ActiveFrame> held,
              const SensorModel& sensor, WallEvidence& evidence);
  /// Those that buildings drawn near the robot have, as far as they are told apart.
  std::vector<double> drawn() const;

 private:
  struct Direction {
    double heading;
    bool is_drawn = false;
    int unwanted = 0;  ///< frames
  };
  WallDirections votes_;
  std::vector<Direction> directions_;
};

}  // namespace handmap
