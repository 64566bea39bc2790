// How recorded odometry errs, as matching with the scans shows it.
#pragma once

#include <deque>

#include "core/pose_graph/motion_factor.h"
#include "core/trajectory/constants.h"

namespace handmap {

/// σ of odometry by the way and the turn, times two scales that are learnt; and its length.
class WheelNoise {
 public:
  /// Nothing is recorded, motions are guessed: a robot keeps its speed from scan to scan, and
  /// turns as it likes.
  static WheelNoise ofGuesses();

  /// Recorded motion, its length corrected, with its noise.
  MotionFactor factor(const Pose2& recorded) const;
  /// σ of (along, aside, heading) of a recorded motion.
  Eigen::Vector3d sigma(const Pose2& recorded) const;
  /// What matching made of it; `least`: of the scales that are learnt.
  void learn(const Pose2& recorded, const Pose2& matched, double least);

  double lengthScale() const { return length_; }

 private:
  bool learns_ = true;
  double length_ = 1.0;
  double move_ = trajectory::kLeastScale;
  double aside_ = trajectory::kLeastScale;
  double turn_ = trajectory::kLeastScale;
  std::deque<double> move_deviations_;
  std::deque<double> turn_deviations_;
  std::deque<double> ratios_;
};

}  // namespace handmap
