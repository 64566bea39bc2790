// Figures of a sketch map from its pairs of landmarks, as those of the Gardony map drawing analyser
// (Gardony, Taylor & Brunyé 2016): which is north and west of which, how far and in what direction.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/pose2.h"

namespace handmap {

struct PairwiseMeasures {
  int landmarks = 0;  ///< of the truth
  int missing = 0;    ///< of them in the drawing
  /// Share of the true relations (north or south of, east or west of; two a pair) that the drawing
  /// has; a pair with a missing one has none.
  double canonical_organisation = 0.0;
  double canonical_accuracy = 0.0;  ///< the same of the pairs that are drawn
  /// Distances as shares of the largest one on the same map, so that scale does not count.
  double distance_accuracy = 0.0;    ///< 1 - mean absolute error
  double scaling_bias = 0.0;         ///< mean error: positive where distances are drawn too long
  double angle_accuracy = 0.0;       ///< 1 - mean absolute error of directions / 180°
  double rotational_bias_rad = 0.0;  ///< mean error of directions, counter-clockwise

  /// Of k of n drawn no more than (k/n)² of the pairs can be right: the root is in k/n.
  double organisationRoot() const;
  double accuracyRoot() const;
};

/// `drawn[i]` is where `truth[i]` was drawn, if it was. With fewer than two drawn all shares are 0.
PairwiseMeasures pairwiseMeasures(const std::vector<Vec2>& truth,
                                  const std::vector<std::optional<Vec2>>& drawn);

}  // namespace handmap
