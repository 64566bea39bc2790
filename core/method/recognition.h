// Whether what a robot sees speaks for or against it being where it is thought to be: that may be
// wrong, however sure the way is in itself.
#pragma once

#include <Eigen/Core>

#include "core/explain/seen_walls.h"

namespace handmap {

/// Less is not worth a word: gaps between buildings.
inline constexpr double kUnrecognised_m = 50.0;

class Recognition {
 public:
  /// `share`: of what was seen `driven_m` after the look before.
  void look(const WallRays::Share& share, double driven_m);
  /// Metres since walls of the drawing were last recognised. What sees no walls says nothing.
  double unrecognised_m() const { return unrecognised_m_; }
  /// Of the stated pose: less sure where more speaks against it than for it.
  void widen(Eigen::Matrix3d& covariance) const;

 private:
  double unrecognised_m_ = 0.0;
  double balance_m_ = 0.0;  ///< metres that speak for it, less those that speak against it
};

}  // namespace handmap
