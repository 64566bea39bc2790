// Why a corrected wall stands where it stands: which observations saw it, what the drawing said,
// and how far each of them pulled.
#pragma once

#include <span>
#include <vector>

#include "core/explain/on_wall.h"
#include "core/map/map.h"
#include "core/perception/scan.h"
#include "core/recording/trajectory.h"

namespace handmap {

/// What one observation saw, robot frame.
struct SeenScan {
  double time_s;
  const Scan* scan;
};

/// An observation whose rays ended on the wall. Offsets are metres across the wall, outwards, from
/// where it stands now.
struct WallWitness {
  double time_s = 0.0;
  Pose2 pose;
  std::vector<Vec2> returns;  ///< where its rays ended, map frame
  double offset_m = 0.0;      ///< mean of the returns, by how surely they are of a wall
  double sigma_m = 0.0;       ///< of that, with what all rays of an observation share
  double share = 0.0;         ///< of all that is known of the wall, 0 … 1
  double pull_m = 0.0;        ///< share · (its offset - that of the drawing)
};

struct WallStory {
  Segment wall{Vec2::Zero(), Vec2::Zero()};  ///< as it stands now
  double sigma_m = 0.0;                      ///< of it, as the run states it
  bool seen = false;                         ///< the same
  double tolerance_m = 0.0;                  ///< returns farther from the wall are not of it
  std::vector<WallWitness> witnesses;        ///< the strongest first
  std::size_t rays = 0;                      ///< of all witnesses
  double drawn_m = 0.0;                      ///< offset of the drawn wall
  double drawn_sigma_m = 0.0;                ///< of the drawing, as it states it
  double drawn_share = 1.0;
  double seen_m = 0.0;        ///< offset that the witnesses alone tell
  double seen_sigma_m = 0.0;  ///< of that; 0 without witnesses
  /// drawn_m and all pulls together: what the wall would be by these rays on this way alone. A run
  /// knows more: the other walls of the building, and the drawing as a whole.
  double explained_m = 0.0;
};

/// Wall `wall` of the footprint of a building, from corner `wall` to the next. `refined`: of a run
/// on `drawing`; `trajectory`: in order of time. Scans whose time is not within it tell nothing. A
/// wall or building that is not there has an empty story.
WallStory storyOf(const Map& drawing, const Map& refined,
                  const std::vector<StampedPose>& trajectory, std::span<const SeenScan> scans,
                  std::size_t building, std::size_t wall, double tolerance_m = explain::kOnWall_m);

}  // namespace handmap
