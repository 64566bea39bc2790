// What happened within a step of the published method, for those who want to look at it.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/polygon.h"

namespace handmap {

/// Filled in by FastSlamPsom::step(); looking changes nothing.
struct SlamTrace {
  struct WeighedPose {
    Pose2 pose;
    double weight;  ///< normalized
  };
  struct Iteration {
    std::vector<Rectangle> members;
    Rectangle best;
    double best_score = 0.0;
  };
  /// One building of the particle that is looked at.
  struct Building {
    std::size_t building;
    std::vector<Iteration> iterations;  ///< the first: before any
  };

  std::vector<WeighedPose> predicted;  ///< with the weights of before
  std::size_t watched = 0;             ///< the particle whose swarms are told: the best of before
  std::vector<Building> buildings;
  std::vector<WeighedPose> weighed;
  bool resampled = false;
  std::size_t survivors = 0;  ///< particles that were drawn at least once
};

}  // namespace handmap
