// Where the map of another robot lies on a drawing: the cells that it has as occupied, laid on the
// drawn walls.
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/map/map.h"
#include "core/map/seen_ground.h"

namespace handmap {

struct GridPlace {
  Pose2 pose;              ///< of the robot map's frame in the map frame
  double supported = 0.0;  ///< share of the drawn walls that faced what was seen and are there
  double median_m = 0.0;   ///< distance of those walls from occupied cells
  double most_m = 0.0;     ///< of nine of ten of them
  double scale = 1.0;      ///< by which the robot's map would have to be stretched to lie best
  double scale_sigma = 0.0;
  std::optional<Pose2> other;  ///< where it lies nearly as well
  bool fits = false;           ///< half of those walls are there, as in maps of the drawn place
};

/// Sought over all shifts and turns; it is not stretched. nullopt: there is nothing straight in it,
/// no building drawn, or `stop` was requested.
std::optional<GridPlace> placeOf(const SeenGround& seen, const Map& drawing,
                                 const std::stop_token& stop = {});

}  // namespace handmap
