// Where a robot is on a map that is right: the way that its sensors tell, laid on the walls.
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/map_match/wall_map.h"
#include "core/odometry/constants.h"
#include "core/outlines/seen_frames.h"
#include "core/pose_graph/pose_graph.h"

namespace handmap {

/// A graph of keyframes, an arrow of odometry from each to the next and one from the map to each at
/// which walls were seen. README.md tells the residuals.
class MatchedTrajectory {
 public:
  /// Keeps a reference to `seen`. The map needs a start.
  MatchedTrajectory(const Map& map, const SeenFrames& seen);

  /// `trajectory`: poses of all observations so far, in any one frame, as told without the map;
  /// those of before may have changed too. One more than before.
  /// `guessed`: of the newest, as Odometry has it.
  void add(const std::vector<Pose2>& trajectory, const OdometryNoise& noise,
           const Eigen::Matrix3d& guessed = Eigen::Matrix3d::Zero());
  /// All observations of a way at once, as if they came one by one, and the end; nothing may have
  /// been added yet. Of no use any more where `stop` was requested.
  void lay(const std::vector<Pose2>& trajectory, const OdometryNoise& noise,
           const std::stop_token& stop);
  /// After the last observation: each keyframe is laid on the walls anew by what was seen before
  /// and after it, until nothing moves any more or `stop` is requested.
  void finish(const std::stop_token& stop);

  /// Of the newest observation, map frame.
  const Pose2& pose() const { return pose_; }
  const Eigen::Matrix3d& covariance() const { return covariance_; }
  /// Of all observations.
  std::vector<Pose2> poses() const;
  /// Buildings of which walls were seen from the last keyframe.
  int visibleBuildings() const { return visible_; }

 private:
  struct Keyframe {
    std::size_t observation;
    Pose2 pose;  ///< map frame
    Eigen::Matrix3d guessed;
    std::optional<MotionFactor> on_walls;
  };
  /// Metres of way behind and ahead of a keyframe that are laid on the walls with it.
  struct Window {
    double behind_m;
    double ahead_m;
  };

  void work(std::size_t observation);
  Eigen::Matrix3d guessedBetween(const Keyframe& from, const Keyframe& to) const;
  MotionFactor motion(const Keyframe& from, const Keyframe& to) const;
  std::vector<ScanPoint> featuresAround(const Keyframe& keyframe, const Window& window) const;
  void layOnWalls(Keyframe& keyframe, const std::vector<ScanPoint>& features,
                  const Eigen::Matrix3d& expected);
  Eigen::Matrix3d carried(const Keyframe& from, const Keyframe& to) const;
  PoseGraph graph() const;
  void optimize();
  Pose2 corrected(std::size_t observation, std::size_t keyframe) const;

  Pose2 start_;
  Eigen::Vector3d start_sigma_;  ///< x, y and heading
  const SeenFrames& seen_;
  WallMap walls_;
  std::vector<Pose2> trajectory_;
  std::vector<double> travelled_m_;
  OdometryNoise noise_ = kWheels;
  Eigen::Matrix3d guessed_ = Eigen::Matrix3d::Zero();  ///< of the newest observation
  std::vector<Keyframe> keyframes_;
  Pose2 pose_;
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d at_keyframe_ = Eigen::Matrix3d::Zero();  ///< of the newest keyframe
  int visible_ = 0;
};

}  // namespace handmap
