// How far a robot has driven among walls of which none is one of the drawing's: it may not be
// where it is thought to be, however sure the way is in itself.
#pragma once

#include <Eigen/Core>

#include "core/session/seen_walls.h"

namespace handmap {

/// Less is not worth a word: gaps between buildings.
inline constexpr double kUnrecognised_m = 50.0;

class Recognition {
 public:
  /// `share`: of what was seen `driven_m` after the look before.
  void look(const WallRays::Share& share, double driven_m);
  /// Metres since walls of the drawing were last recognised. What sees no walls says nothing.
  double unrecognised_m() const { return unrecognised_m_; }
  /// Of the stated pose: less sure where nothing was recognised for long.
  void widen(Eigen::Matrix3d& covariance) const;

 private:
  double unrecognised_m_ = 0.0;
  double distrusted_m_ = 0.0;  ///< the same, less what was recognised since makes up for
};

}  // namespace handmap
