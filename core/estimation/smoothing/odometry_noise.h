// How far odometry is off.
#pragma once

#include <Eigen/Core>

#include "core/geometry/pose2.h"

namespace handmap {

/// Noise of one odometry step, one σ.
struct OdometryNoise {
  double length_per_m = 0.03;            ///< METHOD.md's scenes; FIELD.md (a)
  double side_per_m = 0.01;              ///< FIELD.md (a)
  double heading_variance_per_m = 2e-5;  ///< radians²; FIELD.md (a), its prior
  double heading_per_rad = 0.02;         ///< FIELD.md (a)
  double least_length_m = 0.01;          ///< FIELD.md (a)
  double least_heading = 0.001;          ///< radians; FIELD.md (a)
  /// Of all lengths; Cauchy's, for some wheels are worn. Choice: of well calibrated ones.
  double scale = 0.003;

  /// Of a motion: along, aside, heading.
  Eigen::Vector3d sigmaOf(const Pose2& motion) const;
};

}  // namespace handmap
