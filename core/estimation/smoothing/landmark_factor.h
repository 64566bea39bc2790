// What a frame says of a compact thing.
#pragma once

#include "core/estimation/smoothing/constants.h"
#include "core/estimation/walls/frame.h"
#include "core/pose_graph/factor.h"

namespace handmap {

/// Bearing and range from the pose to the landmark, less those measured; the range with its bias.
/// `systematic_m` as in Smoother. States: the pose, the landmark, the bias.
Factor<2, smoothing::kPoseSize + smoothing::kLandmarkSize + 1> landmarkFactor(
    const Pose2& pose, const Vec2& landmark, const Sighting& sighting, double bias_per_m,
    double systematic_m);

}  // namespace handmap
