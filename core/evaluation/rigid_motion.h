// The shift and turn that brings points onto others.
#pragma once

#include <vector>

#include "core/geometry/pose2.h"

namespace handmap {

/// Least squares over pairs of points (Umeyama, PAMI 1991, without scale):
/// `motion.toOuter(from[i])` is nearest to `to[i]`. Both of one size; one pair gives a shift, none
/// the identity.
Pose2 bestRigidMotion(const std::vector<Vec2>& from, const std::vector<Vec2>& to);

}  // namespace handmap
