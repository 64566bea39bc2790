// Odometry of a range sensor: each scan matched with those of the last 100 m, or each look with
// where the points that were followed have been.
#pragma once

#include <deque>
#include <optional>

#include "core/trajectory/track_map.h"
#include "core/trajectory/wheel_noise.h"

namespace handmap {

class LocalMapOdometry {
 public:
  LocalMapOdometry() = default;
  /// For add() with motions that are guessed: the turn is looked for wider.
  static LocalMapOdometry ofGuesses();

  /// The recorded odometry and what was seen there: a scan, or looks at followed points, which once
  /// there are any are what is matched. Where the match is not to be believed, the odometry goes
  /// on. `moved`: since the last one, where something tells that better than a match. Returns
  /// whether the pose is another than by the odometry.
  bool add(const Pose2& recorded, const std::vector<ScanPoint>& scan,
           const std::vector<TrackedPoint>& tracked = {}, const std::optional<Pose2>& moved = {});

  /// Whether the newest motion was told by what was followed.
  bool isFollowed() const { return followed_; }
  /// Whether there were points that were followed.
  bool hasTracks() const { return has_tracks_; }
  /// What was added last, where all looks have it; robot frame.
  std::vector<ScanPoint> refined(const std::vector<TrackedPoint>& tracked) const {
    return tracks_.refined(tracked, pose_);
  }
  /// How far the newest motion strays: of (along, aside, heading), in the frame of the pose before.
  const Eigen::Matrix3d& variance() const { return variance_; }
  /// Of the newest scan; the first is the first recorded one.
  const Pose2& pose() const { return pose_; }
  /// The direction, of the same frame, in which nothing held the newest match: there the guess went
  /// on. Of guessed motions alone.
  const std::optional<Vec2>& unheld() const { return unheld_; }
  const WheelNoise& noise() const { return noise_; }

 private:
  struct KeptScan {
    int number;
    double travelled_m;
  };
  std::optional<Pose2> matchedPose(const std::vector<ScanPoint>& scan, const Pose2& motion,
                                   const MotionPrior& prior);
  std::optional<Pose2> followedPose(const std::vector<TrackedPoint>& tracked, const Pose2& motion,
                                    const MotionPrior& prior);
  std::optional<ScanMatch> bestMatch(const std::vector<ScanPoint>& scan,
                                     const MotionPrior& prior) const;
  Pose2 whereHeld(const ScanMatch& match, const MotionPrior& prior);
  void keep(const std::vector<ScanPoint>& scan);

  PointMap map_;
  TrackMap tracks_;
  std::deque<KeptScan> kept_;
  WheelNoise noise_;
  bool guessed_ = false;
  bool has_tracks_ = false;
  bool followed_ = false;
  std::optional<Vec2> unheld_;
  Eigen::Matrix3d variance_ = Eigen::Matrix3d::Zero();
  Pose2 pose_;
  Pose2 recorded_;
  std::optional<Pose2> kept_at_;
  double travelled_m_ = 0.0;
  int scans_ = 0;
};

}  // namespace handmap
