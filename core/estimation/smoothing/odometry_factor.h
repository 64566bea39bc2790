// What the odometry says of two poses after one another.
#pragma once

#include "core/estimation/smoothing/constants.h"
#include "core/estimation/walls/frame.h"
#include "core/odometry/odometry_noise.h"
#include "core/pose_graph/factor.h"

namespace handmap {

/// A motion, the scale of the odometry's lengths (less 1) taken into account.
inline Pose2 scaled(const Pose2& motion, double scale) {
  return {(1.0 + scale) * motion.x, (1.0 + scale) * motion.y, motion.heading};
}

/// R(from)ᵀ (to − from) less the motion as counted and scaled, and the same of the heading. States:
/// both poses, the scale.
Factor<3, 2 * smoothing::kPoseSize + 1> odometryFactor(const Frame& from, const Frame& to,
                                                       double scale, const OdometryNoise& noise);

}  // namespace handmap
