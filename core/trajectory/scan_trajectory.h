// The way of a range sensor from what it sees of itself: no drawing is used.
#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/perception/perception.h"

namespace handmap {

struct TrajectoryOptions {
  double range_limit_m = 60.0;  ///< nothing farther is measured
  bool close_loops = true;      ///< false: poses() are those of odometry()
};

/// Local map odometry, loops between submaps and a graph of poses. One thread; the same inputs give
/// the same poses.
class ScanTrajectory {
 public:
  explicit ScanTrajectory(const TrajectoryOptions& options);
  ~ScanTrajectory();
  ScanTrajectory(const ScanTrajectory&) = delete;
  ScanTrajectory& operator=(const ScanTrajectory&) = delete;
  ScanTrajectory(ScanTrajectory&&) noexcept;
  ScanTrajectory& operator=(ScanTrajectory&&) noexcept;

  /// One observation: the recorded odometry, and the returns in the robot frame as recorded (empty
  /// where there are none: the odometry alone goes on). `ids`: as View has them, of the returns.
  /// `moved`: since the last one, where something tells that better than the odometry. Always adds
  /// one pose. A stop leaves out the search for loops and makes the call return soon.
  void add(double time_s, const Odometry& odometry, const std::vector<RangePoint>& points,
           const std::stop_token& stop = {}, const std::vector<std::uint32_t>& ids = {},
           const std::optional<Pose2>& moved = {});
  /// With what was seen, whatever by: of images the likely walls, and the motion that they tell.
  void add(double time_s, const Odometry& odometry, const Percept& percept,
           const std::stop_token& stop);

  /// Of the newest observation, by matching with the last scans: smooth, does not jump where a loop
  /// is closed. The first is the first recorded odometry.
  Pose2 odometry() const;
  /// Of all observations, the newest too, loops closed; the first is the first recorded odometry.
  /// Where the sensor does not allow it they are those of the recorded odometry.
  const std::vector<Pose2>& poses() const { return usable() ? scanPoses() : recorded(); }
  /// Whether there are straight pieces to match, or points were followed, and the way by scans
  /// makes what was seen at least as sharp as the recorded odometry does. Looked at anew whenever
  /// there is a quarter more to see.
  bool usable() const;

  /// Whether it is usable and most motions were told by what was followed.
  bool isFollowed() const;

  /// Whether there were points that were followed, by their numbers.
  bool hasTracks() const;

  /// What comes was put together by an odometry: matched with itself it tells that odometry again.
  /// Only points that were followed tell a way then.
  void setJoined();

  const std::vector<Pose2>& scanPoses() const;  ///< as poses(), usable or not
  const std::vector<Pose2>& recorded() const;   ///< the recorded odometry of all observations
  /// sharpnessOf() of what was seen, along any way of the same observations. Some 0.1 s.
  double sharpness(const std::vector<Pose2>& trajectory) const;
  /// The same of what was seen until now, to be asked at any time later and in any thread.
  std::function<double(const std::vector<Pose2>&)> sharpnessLater() const;
  /// One σ of the sensor's ranges at this distance, metres, as the scans themselves show it.
  double rangeNoise(double range_m) const;
  /// σ of the motions of poses() over that of the recorded odometry, 0.1 to 1: how far closing the
  /// loops bent the way by scans, against how far the recorded odometry is off it. 1 where it is
  /// not usable.
  double noiseScale() const;
  /// Of the newest of poses() where they are by scans: (x, y, heading), in the odometry frame,
  /// given the first.
  const Eigen::Matrix3d& covariance() const;
  /// One σ of what scanPoses() as a whole may be turned about the first, radians; while they are
  /// usable.
  double turn() const;
  double lengthScale() const;  ///< length of the way by scans over that by recorded odometry
  int loops() const;           ///< closed so far

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace handmap
