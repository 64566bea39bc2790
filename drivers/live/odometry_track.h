// The last minute of a robot's odometry.
#pragma once

#include <deque>
#include <optional>

#include "core/recording/trajectory.h"

namespace handmap {

class OdometryTrack {
 public:
  /// False: not later than the newest, and left out.
  bool add(double time_s, const Pose2& pose);

  const std::optional<StampedPose>& newest() const { return newest_; }
  /// Interpolated between two poses not more than 1.5 s apart. nullopt where there are none around
  /// that time: not yet, or never.
  std::optional<Pose2> at(double time_s) const;
  /// Poses before and after that time are known.
  bool isAround(double time_s) const;
  /// Between the newest two poses; 0 where something is missing between them.
  double period_s() const;
  /// So long the robot has not moved, at the newest pose; 0 where there is none.
  double standingFor() const;

 private:
  std::deque<StampedPose> poses_;
  std::optional<StampedPose> newest_;
  std::optional<StampedPose> stood_at_;  ///< since then no motion
};

}  // namespace handmap
