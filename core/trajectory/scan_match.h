// One scan laid on a map of points: robust point-to-line matching.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/pose_graph/motion_factor.h"
#include "core/trajectory/factors.h"
#include "core/trajectory/point_map.h"

namespace handmap {

struct ScanMatch {
  Pose2 pose;
  Eigen::Matrix3d information;  ///< of (x, y, heading) from the returns alone, as if independent
  double misfit = 1.0;  ///< mean square of the residuals, 1 where they are as the model has them
  double chance = 0.0;  ///< what noise that turns the lines would tell of any direction, likewise
  int matched = 0;      ///< returns that the last step used
  int known = 0;        ///< returns on straight pieces, or of followed points
  int near = 0;         ///< of those, how many found a line within 0.25 m, or a point within 0.5
  double own = 1.0;     ///< how much each return tells of its own: neighbours are wrong together
};

/// Where the robot was in the last step, and what its odometry says of the motion since.
struct MotionPrior {
  Pose2 from;
  MotionFactor motion;
};

/// Gauss-Newton from `start`, once for each gate: the nearest point of the map within the gate, in
/// metres. nullopt where nothing fixes the pose.
std::optional<ScanMatch> matchScan(const std::vector<ScanPoint>& scan, const PointMap& map,
                                   const Pose2& start, std::span<const double> gates_m,
                                   const std::optional<MotionPrior>& prior = {});

/// What the returns tell of the place in the direction in which they tell least, as a share of what
/// they tell in the best one.
double weakerShare(const ScanMatch& match);

/// Root of the information of a match; poses and walls are off by `floor_sigma` (x, y, heading)
/// beside. nullopt where the returns do not fix the pose.
std::optional<Eigen::Matrix3d> rootInformation(const ScanMatch& match,
                                               const Eigen::Vector3d& floor_sigma);

}  // namespace handmap
