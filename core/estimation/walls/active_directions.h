// Which directions the evidence looks for walls in.
#pragma once

#include <span>
#include <vector>

#include "core/estimation/walls/wall_evidence.h"

namespace handmap {

/// Follows what is drawn near the robot: a direction is taken up when it is wanted and given up
/// when it has not been for a while.
class ActiveDirections {
 public:
  /// Brings `evidence`, which holds the `held` frames, up to date.
  void update(std::span<const double> drawn, std::span<const ActiveFrame> held,
              WallEvidence& evidence);
  /// Those that buildings drawn near the robot have, as far as they are told apart.
  std::vector<double> drawn() const;

 private:
  struct Direction {
    double heading;
    int unwanted = 0;  ///< frames
  };
  std::vector<Direction> directions_;
};

}  // namespace handmap
