// How far a map and a trajectory are from the truth (the paper's measures).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/map/map.h"
#include "core/recording/trajectory.h"

namespace handmap {

/// Signed errors of one building, metres, along and across the front wall of the true one: the wall
/// of its box nearest the true route, or the line through the true start along its heading. Without
/// either it is the one of the two walls along the building's heading that is nearer to the middle
/// of the map. A building whose heading is a quarter off is compared by its sides, whatever they
/// are called.
struct BuildingError {
  std::string id;
  double x = 0.0;         ///< centre, along; in the sense of the true heading, or to the left of it
  double front = 0.0;     ///< the front wall, across; positive where the building comes too near
  double width = 0.0;     ///< of the front wall
  double iou = 0.0;       ///< 0 … 1
  bool overlaps = false;  ///< success as the paper defines it
};

struct MeanErrors {
  int buildings = 0;
  double x = 0.0;  ///< means of absolute errors
  double front = 0.0;
  double width = 0.0;
  double iou = 0.0;
};

struct MapComparison {
  std::vector<BuildingError> buildings;  ///< those in both maps, in the order of the truth
  std::vector<std::string> missing;      ///< ids only the truth has
  std::vector<std::string> extra;        ///< ids only the other map has
  Pose2 alignment;  ///< the shift and turn that was applied to the map first (identity: as it is)

  MeanErrors mean(const std::vector<std::string>& ids = {}) const;  ///< empty: all
};

/// `aligned`: after the best rigid motion of the whole map (least squares over the centres).
MapComparison compareMaps(const Map& map, const Map& truth, bool aligned);

struct TrajectoryError {
  int poses = 0;
  double rms_m = 0.0;
  double max_m = 0.0;
  double end_m = 0.0;
  double rms_heading = 0.0;    ///< radians
  double aligned_rms_m = 0.0;  ///< after the best rigid motion
  double length_m = 0.0;       ///< of the truth
};

/// As they are, in the map frame, at the times of `estimate` that the truth covers.
/// nullopt when they have no time in common.
std::optional<TrajectoryError> compareTrajectories(const std::vector<StampedPose>& estimate,
                                                   const Trajectory& truth);

}  // namespace handmap
