// How uncertain a pose is that recorded odometry alone tells.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/recording/odometry.h"

namespace handmap {

class WheelUncertainty {
 public:
  /// The odometry of the next observation.
  void add(const Odometry& odometry);
  /// Of the newest pose, (x, y, heading) in the odometry frame, given the first.
  const Eigen::Matrix3d& covariance() const { return covariance_; }

 private:
  std::optional<Odometry> last_;
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
};

}  // namespace handmap
