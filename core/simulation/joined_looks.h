// The looks of the last metres of a way, put together where the odometry says they were taken.
#pragma once

#include <deque>

#include "core/recording/observation.h"

namespace handmap {

/// As `boulevard/dense` was made: above 0.3 m, within 35 m, one (the newest) a cell of 0.12 m. A
/// track stands in it with many looks, all with its number.
class JoinedLooks {
 public:
  explicit JoinedLooks(double metres) : metres_(metres) {}

  /// The view, whose points are in the robot frame, with what was seen before it.
  View add(const View& view, const Pose2& odometry);

 private:
  struct Look {
    double at_m;  ///< so far had it driven
    Pose2 odometry;
    View view;
  };

  double metres_;
  double driven_m_ = 0.0;
  std::deque<Look> looks_;
};

}  // namespace handmap
