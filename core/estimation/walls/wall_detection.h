// Walls in the evidence, found without the drawing.
#pragma once

#include <vector>

#include "core/estimation/walls/wall_evidence.h"

namespace handmap {

/// A straight wall: seen from its right when one looks from a to b.
struct FoundWall {
  Vec2 a = Vec2::Zero();
  Vec2 b = Vec2::Zero();
  double score = 0.0;  ///< log ratio against no wall

  double heading() const { return std::atan2(b.y() - a.y(), b.x() - a.x()); }
  double length() const { return (b - a).norm(); }
};

struct DetectionOptions {
  double least_score = 25.0;    ///< nats; choice: a wall alone; 40 with its sides make a building
  double least_length_m = 3.0;  ///< choice: a garage
  double drop = 15.0;  ///< a wall ends where the evidence behind its end has fallen by so much,
                       ///< nats; METHOD.md 3
  std::vector<double> tilts = {0.0,
                               toRadians(1.5),
                               toRadians(-1.5),
                               toRadians(3.0),
                               toRadians(-3.0),
                               toRadians(4.5),
                               toRadians(-4.5)};
};

/// Walls within `reach_m` (per axis) of `middle`, the surest first; of those that lie on one
/// another only the surest.
std::vector<FoundWall> detectWalls(const WallEvidence& evidence, const Vec2& middle, double reach_m,
                                   const DetectionOptions& options);

}  // namespace handmap
