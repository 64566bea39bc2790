// The outlines near a given one that explain the rays best.
#pragma once

#include <array>
#include <stop_token>
#include <vector>

#include "core/base/random.h"
#include "core/outlines/outline_score.h"

namespace handmap {

/// An outline and how it may be wrong, one σ each.
struct OutlinePrior {
  Polygon start;         ///< counter-clockwise
  double heading = 0.0;  ///< of its axes: along its longest wall
  double shift_m = 3.0;
  double turn = 0.08;      ///< radians
  double log_scale = 0.3;  ///< of each axis
  double shear = 0.03;
  /// log of the size along each axis that is most probable, as a share of that of `start`. One
  /// that differs by more than kMostSizeOff is that of another thing.
  Vec2 expected_log_size = Vec2::Zero();
};

/// Shift (m), turn, logs of both scales, shear.
using OutlineMove = std::array<double, 6>;

struct FittedOutline {
  Polygon outline;
  OutlineMove move{};    ///< of the prior's start
  double score = 0.0;    ///< log ratio against nothing there, without what the prior says
  double against = 0.0;  ///< of it, what walls tell that speak against it; at most 0
  double prior = 0.0;    ///< log density of the prior, at most 0
  double total() const { return score + prior; }
};

/// What the evidence tells of which thing the building is: that one stands there, and ever less how
/// much of it is seen. A long wall explains more than the right one; walls where rays go through
/// count in full. `less`: nats that are taken off.
double tellsWhichThing(const FittedOutline& place, double less = 0.0);

/// Samples of the prior, the best of them by CMA-ES with ever narrower walls: those that explain
/// most, and as many that tell most of which thing the building is. Places that differ, the one
/// that explains most first: which of them is right may depend on the neighbours. The same random
/// numbers give the same outlines. Comes back at once, with any outline, where `stop` is requested.
std::vector<FittedOutline> searchOutlines(const OutlinePrior& prior, const OutlineScorer& scorer,
                                          RandomStream random, const std::stop_token& stop = {});

/// From a place near by, with the narrow walls alone.
FittedOutline searchNear(const OutlineMove& start, const OutlinePrior& prior,
                         const OutlineScorer& scorer, RandomStream random,
                         const std::stop_token& stop = {});

/// As large as a rectangle, and there: nothing is looked for.
FittedOutline placedOn(const Rectangle& box, const OutlinePrior& prior);
void scorePlace(FittedOutline& place, const OutlineScorer& scorer);

/// How far the side of the outline that lies farthest along a direction may be moved, the opposite
/// one staying, before rays and prior make it less probable by what one σ does; metres.
double spreadOfSide(const Polygon& outline, const Vec2& direction, double prior_sigma_m,
                    const OutlineScorer& scorer);

}  // namespace handmap
