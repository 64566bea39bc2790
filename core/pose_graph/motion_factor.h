// A motion between two poses, as measured. Poses are (x, y, heading), changed by addition.
#pragma once

#include <optional>

#include "core/geometry/pose2.h"
#include "core/pose_graph/factor.h"

namespace handmap {

struct MotionFactor {
  Pose2 motion;                      ///< the second pose in the frame of the first
  Eigen::Matrix3d root_information;  ///< of (along, aside, heading), in the frame of the first

  /// R(from)ᵀ (to − from) less the motion, and the same of the heading, whitened. States: both
  /// poses.
  Factor<3, 6> at(const Pose2& from, const Pose2& to) const;
};

/// The same motion, so much less sure: variance of (along, aside, heading), in the frame of the
/// first.
MotionFactor loosened(const MotionFactor& motion, const Eigen::Matrix3d& variance);

/// The upper root of what is to be one; nullopt where it is no information.
std::optional<Eigen::Matrix3d> rootOf(const Eigen::Matrix3d& information);

/// Pose after a step of (x, y, heading).
Pose2 stepped(const Pose2& pose, const Eigen::Vector3d& step);

}  // namespace handmap
