// Whether what a robot sees speaks for or against it being where it is thought to be: that may be
// wrong, however sure the way is in itself.
#pragma once

#include <Eigen/Core>

#include "core/explain/seen_walls.h"
#include "core/method/snapshot.h"

namespace handmap {

class Recognition {
 public:
  enum class Drawing { FromMemory, True };
  struct Rates;

  explicit Recognition(Drawing drawing);

  /// `share`: of what was seen `driven_m` after the look before. `guessed` as Odometry has it:
  /// after a motion that was, what spoke for the robot before says nothing of where it is.
  void look(const WallRays::Share& share, double driven_m,
            const Eigen::Matrix3d& guessed = Eigen::Matrix3d::Zero());
  /// The trust in a pose of this covariance: less sure where more speaks against it than for it.
  void state(Eigen::Matrix3d covariance, FrameReport& report) const;

 private:
  bool is_true_;
  const Rates& rates_;
  double unrecognised_m_ = 0.0;                        ///< what sees no walls says nothing
  Eigen::Matrix3d guessed_ = Eigen::Matrix3d::Zero();  ///< that is counted
  double balance_m_ = 0.0;  ///< metres that speak for it, less those that speak against it
};

}  // namespace handmap
