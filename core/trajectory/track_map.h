// Points that were followed: each is known again by its number, from wherever it is seen.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/trajectory/scan_match.h"

namespace handmap {

/// A look at one.
struct TrackedPoint {
  std::uint32_t id;
  Vec2 at;       ///< robot frame, metres
  float height;  ///< above the robot's ground, metres
};

/// Where each of them is, as all looks at it have it together.
class TrackMap {
 public:
  /// From where odometry has the robot, with what that knows: it is believed as little as anything
  /// else that contradicts most points. nullopt where fewer than three are known.
  std::optional<ScanMatch> match(const std::vector<TrackedPoint>& seen,
                                 const MotionPrior& prior) const;
  /// What was seen from `pose`, after so much of the way. A point that is not where it was begins
  /// anew: it moves, or its number was given again.
  void add(const std::vector<TrackedPoint>& seen, const Pose2& pose, double travelled_m);
  /// What was added last from there, but where all looks have it; robot frame.
  std::vector<ScanPoint> refined(const std::vector<TrackedPoint>& seen, const Pose2& pose) const;

 private:
  struct Landmark {
    Vec2 at;  ///< outer frame
    Eigen::Matrix2d covariance;
    double travelled_m;
  };
  std::unordered_map<std::uint32_t, Landmark> landmarks_;
};

}  // namespace handmap
