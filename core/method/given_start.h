// Where a run began, told by poses that somebody gave later.
#pragma once

#include <vector>

#include "core/map/map.h"
#include "core/method/wheel_uncertainty.h"
#include "core/perception/perception.h"
#include "core/trajectory/scan_trajectory.h"

namespace handmap {

/// Matched scans tell the way between better than a hand tells either end: start and given poses
/// are told together. Where wheels alone tell it, the start is doubted only where they cannot be as
/// far off.
///
/// States: the start and the robot where poses were given, map frame. Residuals: each of them as it
/// was said, σ those of a hand (of the start, what the drawing says of it), and the way from the
/// start to each. What was said before is doubted (Cauchy), what was said last is not.
class GivenStart {
 public:
  /// `given`: map frame, increasing in time, at least one.
  GivenStart(const Map& drawing, const SourceInfo& source, std::vector<StampedPose> given);

  bool isDone() const { return along_.size() == given_.size(); }
  void add(double time_s, const Odometry& odometry, const Percept& percept,
           const std::stop_token& stop);
  /// Whether scans told the way to all of them.
  bool isByScans() const;
  /// The drawing with its start as told, and how sure that is.
  Map drawing() const;

 private:
  struct Way {
    Pose2 motion;              ///< from the start
    Eigen::Matrix3d variance;  ///< frame of the start
  };
  struct Along {
    std::size_t observation;
    double share;  ///< of the way to it from the one before
    double driven_m;
    Eigen::Matrix3d by_scans;  ///< covariance of the pose, odometry frame, the first held
    Eigen::Matrix3d by_wheels;
  };
  Way wayTo(const Along& along, bool by_scans) const;
  bool mayDrift(const Way& way) const;

  Map drawing_;
  Pose2 start_odometry_;
  std::vector<StampedPose> given_;
  ScanTrajectory trajectory_;
  WheelUncertainty wheels_;
  std::vector<Along> along_;  ///< the way to each
  double last_s_ = 0.0;
  double driven_m_ = 0.0;
  Eigen::Matrix3d guessed_ = Eigen::Matrix3d::Zero();
};

}  // namespace handmap
