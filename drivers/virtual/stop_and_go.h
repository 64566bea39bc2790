// A robot that someone drives from stop to stop, and on when its head has looked around. Pure: who
// calls it says what time it is. Seconds since it was switched on.
#pragma once

#include "core/recording/trajectory.h"

namespace handmap {

class StopAndGo {
 public:
  /// `truth` and `odometry`: poses at the same times, of which each is a stop.
  StopAndGo(std::vector<StampedPose> truth, std::vector<StampedPose> odometry);

  /// `head_away`: it does not look ahead. Times do not decrease.
  void tick(double now_s, bool head_away);

  Pose2 pose() const;      ///< map frame
  Pose2 odometry() const;  ///< odometry frame

 private:
  Trajectory truth_;
  Trajectory odometry_;
  std::size_t next_ = 0;  ///< the stop it stands at, or drives to
  double way_s_ = 0.0;    ///< time of the way, which stands while the robot does
  double last_s_ = 0.0;   ///< the latest tick
  double ahead_since_s_ = 0.0;
  double stands_since_s_ = 0.0;
  bool looked_ = false;  ///< the head was away at this stop
  bool stands_ = true;
};

}  // namespace handmap
