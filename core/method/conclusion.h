// What a run comes to: which way is believed, and the drawing fitted to what was seen along it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/estimation/drawing/drawing_motion.h"
#include "core/map/map.h"
#include "core/outlines/seen_frames.h"

namespace handmap {

/// A way of the robot that is thought of: poses of all observations, map frame.
struct TrajectoryHypothesis {
  enum class By { Buildings, Odometry, Scans, Walls };
  By by;
  std::vector<Pose2> poses;
  double turn = 0.0;      ///< it may be turned about its start by so much, one σ, radians
  bool followed = false;  ///< corner by corner in images: no drawing tells it better
};

/// What is known after some observations; a copy, so that any thread may conclude from it while the
/// run goes on.
struct RunKnowledge {
  TrajectoryHypothesis alone;                 ///< by scans or the odometry: no drawing is in it
  TrajectoryHypothesis buildings;             ///< as the buildings moved it
  std::optional<TrajectoryHypothesis> walls;  ///< laid on a drawing that is true
  Map found;                                  ///< the drawing as the estimator corrected it
  std::function<Map()> predicted;             ///< where what was found has each, but for itself
  DrawingMotion motion;
  SeenFrames seen;
  /// Of a way: how sharp it makes what was seen. See sharpnessOf().
  std::function<double(const std::vector<Pose2>&)> sharpness;
};

struct Conclusion {
  TrajectoryHypothesis trajectory;  ///< on the map; what tells it goes on from there
  Map map;
  std::optional<Eigen::Matrix3d> covariance;  ///< of its newest pose, where it was laid on a map
  /// See RefinedMap.
  std::optional<Eigen::Matrix3d> start_variance = {};
  std::optional<Pose2> start_off = {};  ///< the drawn start, where the buildings refute it
  bool unfounded = false;  ///< buildings that were found were dropped: few walls stand there
};

/// Outlines are fitted late: a conclusion on the way that leaves a building as it is drawn, and has
/// seen no more of it than what found it elsewhere, has nothing to say against that.
bool isBetterFounded(const Building& concluded, const Building& found, const Building& drawn);

/// nullopt where `stop` was requested.
std::optional<Conclusion> conclude(const Map& drawing, const RunKnowledge& known,
                                   std::uint64_t seed, const std::stop_token& stop = {},
                                   const std::function<void(double)>& progress = {});

}  // namespace handmap
