// Buildings that are found again after a long way: which they are, and so how far the way drifted.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/estimation/box_finder.h"

namespace handmap {

/// A parameter of a box (see Box::reach; the fifth is its heading) that another box has as well.
struct Agreement {
  std::size_t old_parameter;
  std::size_t again_parameter;
  double error;  ///< old less again: metres to the wall of the old box, or radians
  Eigen::Matrix<double, 5, 1> old_slope;    ///< of the error, by the parameters
  Eigen::Matrix<double, 5, 1> again_slope;  ///< the same
  Vec2 normal;                              ///< of the wall
  Vec2 point;                               ///< in the middle of the wall of the new box
  double variance;                          ///< of what is known of the two
};

/// What two boxes of one building agree in: the walls that were seen both times and, last, the
/// heading. Empty where there is no such wall.
std::vector<Agreement> compare(const FoundBox& old, const FoundBox& again);

/// What an old box is after it was found again.
FoundBox merged(const FoundBox& old, const FoundBox& again);

/// Two found boxes that are one building, by index.
struct SameBuilding {
  std::size_t old;
  std::size_t again;
};

/// The boxes, each pair one, in the place of the old.
std::vector<FoundBox> merged(std::span<const FoundBox> boxes, std::span<const SameBuilding> pairs);

/// How far the way may have drifted since the old boxes were seen, about `here`; one σ.
struct DriftPrior {
  Vec2 here = Vec2::Zero();  ///< map frame
  double shift_m = 1.0;
  double turn = 0.03;  ///< radians
};

/// Which of the pairs that the labels tell are right, if the boxes agree with each other; nullopt
/// where that is not sure. One building alone may be any: there are at least two.
std::optional<std::vector<SameBuilding>> closeLoop(std::span<const FoundBox> boxes,
                                                   std::span<const SameBuilding> candidates,
                                                   const DriftPrior& prior);

}  // namespace handmap
