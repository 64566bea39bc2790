// Walls in the evidence, found without the drawing.
#pragma once

#include <span>
#include <vector>

#include "core/estimation/walls/constants.h"
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

/// Walls within `reach_m` (per axis) of `middle`, the surest first; of those that lie on one
/// another only the surest. `tilts`: of rows to those of the directions, radians.
std::vector<FoundWall> detectWalls(const WallEvidence& evidence, const Vec2& middle, double reach_m,
                                   std::span<const double> tilts = walls::kTilts);

}  // namespace handmap
