// The drawing after a run: each building fitted to what was seen, or as it was drawn.
#pragma once

#include <optional>

#include "core/estimation/drawing_motion.h"
#include "core/outlines/map_fit.h"

namespace handmap {

/// The drawing as the estimator corrected it.
struct FoundMap {
  const Map& map;
  const DrawingMotion& motion;  ///< how the drawing as a whole lies
};

/// `way`: the poses of all observations, map frame. Without `found` the drawing is where it was
/// drawn. nullopt where `stop` was requested.
std::optional<Map> refine(const Map& drawing, const std::optional<FoundMap>& found,
                          const SeenFrames& seen, const std::vector<Pose2>& way, std::uint64_t seed,
                          const std::stop_token& stop = {},
                          const std::function<void(double)>& progress = {});

}  // namespace handmap
