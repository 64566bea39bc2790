// How sharp a way makes what was seen along it: a measure of ways that needs no truth.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/geometry/pose2.h"
#include "core/trajectory/constants.h"

namespace handmap {

/// A return in the plane of the robot, metres.
struct SharpnessPoint {
  Vec2 at = Vec2::Zero();
  double sigma = perception::kLaserSigma_m;  ///< noise along the ray from the robot, one σ
};

/// What one observation saw, near enough to be measured well; nullptr where it adds nothing to the
/// one before. The same frames for all ways that are compared, in whichever threads.
using SharpnessFrame = std::shared_ptr<const std::vector<SharpnessPoint>>;

struct SharpnessOptions {
  int samples = trajectory::kSamples;
  double apart_m =
      trajectory::kElsewhere_m;  ///< of way between two looks at one place that are compared
  std::uint64_t seed = 1;
};

/// Mean over random points of log(0.001 + the density there of what was seen from elsewhere on the
/// way); greater is sharper. It judges the shape of the way over some tens of metres, not slow
/// drift, nor where the way as a whole lies. One pose a frame. 0 where nothing can be compared.
double sharpnessOf(const std::vector<SharpnessFrame>& frames, const std::vector<Pose2>& poses,
                   const SharpnessOptions& options = {});

}  // namespace handmap
