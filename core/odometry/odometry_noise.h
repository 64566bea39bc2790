// How far a measured motion is off.
#pragma once

#include <Eigen/Core>

#include "core/geometry/pose2.h"

namespace handmap {

/// Of a step of odometry, one σ. What grows with the length of the way grows with its heading's
/// variance; the rest in proportion.
struct OdometryNoise {
  double along_per_m;
  double aside_per_m;
  double least_m;
  double heading_variance_per_m;  ///< radians²
  double heading_per_rad;         ///< of a turn
  double least_heading;           ///< radians

  bool operator==(const OdometryNoise&) const = default;
  /// Of (along, aside, heading).
  Eigen::Vector3d sigmaOf(const Pose2& motion) const;
};

/// Wheels on roads: FIELD.md (a), METHOD.md's scenes.
inline constexpr OdometryNoise kWheels{0.03, 0.01, 0.01, 2e-5, 0.02, 0.001};
/// Scans matched with those of the last hundred metres: prototypes on the laser of a campus.
inline constexpr OdometryNoise kMatchedScans{0.012, 0.006, 0.02, 4.9e-7, 0.006, 0.0015};

}  // namespace handmap
