// What a drawing proves to be worth: which of its buildings are right as they are drawn.
#pragma once

#include <vector>

#include "core/map/map.h"

namespace handmap {

/// Of a drawing and the same drawing fitted to what was seen.
struct Agreement {
  /// From the drawing to where the run put it as a whole, as the buildings that are drawn right
  /// say.
  Pose2 motion;
  /// By building: how probable it is that it is drawn right. Of one that was not seen: as the share
  /// of those that are.
  std::vector<double> right;
  double share = 0.0;  ///< of those that were seen that are drawn right
  /// The buildings together say that the drawn start is off, by the motion.
  bool refutes_start = false;
  /// Of the motion: shift and turn about the start.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double way_turn = 0.0;  ///< what the buildings leave of it

  bool isRight(std::size_t building) const { return right[building] > 0.5; }
  /// How well it is known where what lies so far from the start is: the rms of any direction.
  double sigmaAt(const Vec2& from_start) const;
};

/// `start_turn`, `start_m`: how well the start tells how the map as a whole lies, one σ;
/// `way_turn`: what was seen may beside that be turned about the start with the way, as all
/// buildings tell together. The sides that
/// were seen are compared (sidesOf()): a mixture of buildings that are drawn right, up to what
/// fitting is off, and others. How many are right, and how far the others are off, is found by
/// expectation and maximization (README.md).
Agreement agreementOf(const Map& drawing, const Map& fitted, double start_m, double start_turn,
                      double way_turn = 0.0);

}  // namespace handmap
