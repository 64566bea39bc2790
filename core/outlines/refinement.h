// The drawing after a run: each building fitted to what was seen, or as it was drawn.
#pragma once

#include <optional>

#include "core/estimation/drawing/drawing_motion.h"
#include "core/outlines/map_fit.h"

namespace handmap {

/// The drawing as the estimator corrected it.
struct FoundMap {
  const Map& map;
  const DrawingMotion& motion;  ///< how the drawing as a whole lies
};

struct RefinedMap {
  Map map;
  /// From the frame of the map to that of the way that was given: where many buildings prove to be
  /// drawn right they tell better than the start how the way lies.
  Pose2 motion;
  double right = 0.0;  ///< share of the buildings that were seen that are as drawn
  /// Of shift and turn about the start, where the drawing says that it is off or the buildings do.
  std::optional<Eigen::Matrix3d> start_variance = {};
  bool refutes_start = false;  ///< they do, and it is off by the motion
  double way_turn = 0.0;       ///< what the buildings leave of it, one σ, radians
};

/// Where rays meet the drawn outlines: the share of the buildings for which they speak there.
double supportOf(const Map& drawing, const PlacedRays& placed, double range_limit_m,
                 const std::stop_token& stop = {});

/// `placed`: what was seen, along a way in the frame of the map. Without `found` the drawing is
/// where it was drawn. `way_turn`: the way may be turned about its start by so much, one σ,
/// radians, and what is seen along it with it; all buildings together tell by how much it is.
/// nullopt where `stop` was requested.
std::optional<RefinedMap> refine(const Map& drawing, const std::optional<FoundMap>& found,
                                 const PlacedRays& placed, double range_limit_m, std::uint64_t seed,
                                 const std::stop_token& stop = {},
                                 const std::function<void(double)>& progress = {},
                                 double way_turn = 0.0);

}  // namespace handmap
