// Two found boxes that are one building.
#pragma once

#include <span>
#include <vector>

#include "core/estimation/buildings/found_box.h"

namespace handmap {

/// Found twice: before the robot had been far away, and after.
struct SameBuilding {
  FoundId old;
  FoundId again;
};

/// A parameter of a box (see Box::reach; the fifth is its heading) that another box has as well.
struct SharedParameter {
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
std::vector<SharedParameter> compare(const FoundBox& old, const FoundBox& again);

/// What an old box is after it was found again.
FoundBox merged(const FoundBox& old, const FoundBox& again);

/// The boxes, each pair one, in the place of the old.
std::vector<FoundBox> merged(std::span<const FoundBox> boxes, std::span<const SameBuilding> pairs);

}  // namespace handmap
