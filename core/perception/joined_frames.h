// Points that were put together from several frames by the odometry say the same thing again and
// again, from where it was not looked at, and match themselves.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/pose2.h"
#include "core/recording/observation.h"

namespace handmap {

/// Takes out of each frame what frames before had at the same place of the odometry frame, where
/// the last one had most of it, or where one has a followed point twice. A sensor never measures a
/// place again to the millimetre; other frames with one return a direction are left as they are.
class JoinedFrames {
 public:
  /// Points of the next frame, and where the robot is. Where they are no repeats they stay.
  void removeRepeats(SeenPoints& seen, const Pose2& odometry);

  /// Whether the last ones were put together so.
  bool areJoined() const { return joined_; }

 private:
  bool wasThere(const Eigen::Vector3d& p) const;
  bool repeat(const std::vector<Eigen::Vector3d>& placed) const;

  Pose2 last_;
  std::vector<Eigen::Vector3d> before_;            ///< points of the last frame, odometry frame
  std::unordered_map<std::int64_t, double> seen_;  ///< places, and how far was driven by then
  double driven_m_ = 0.0;
  bool joined_ = false;
};

}  // namespace handmap
