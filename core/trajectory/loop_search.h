// Places that were passed before, found by what was seen there.
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/pose_graph/motion_factor.h"
#include "core/trajectory/constants.h"
#include "core/trajectory/submap.h"

namespace handmap {

/// The pose of keyframe `to` in the frame of keyframe `from`.
struct Loop {
  std::size_t from;
  std::size_t to;
  MotionFactor motion;
};

class LoopSearch {
 public:
  /// With more than `most_points`, 40 bytes each, every second scan of those passed is let go: of a
  /// planar scanner after four kilometres.
  explicit LoopSearch(std::size_t most_points = trajectory::kMostPoints)
      : most_points_(most_points) {}

  /// The next keyframe: its pose by local map odometry, which is right over some tens of metres,
  /// and what was seen there.
  void add(const Pose2& smooth, const std::vector<ScanPoint>& scan);

  /// Loops of the newest keyframe that has enough after it; `poses`: the best known, one for each
  /// keyframe. A stop ends the search.
  std::vector<Loop> search(const std::vector<Pose2>& poses, const std::stop_token& stop);

  std::size_t points() const { return points_; }  ///< that it keeps

 private:
  struct Keyframe {
    Pose2 smooth;
    double travelled_m;
    std::vector<ScanPoint> scan;
  };
  std::vector<ScanPoint> submap(std::size_t middle, std::size_t reach) const;
  std::vector<std::size_t> candidates(std::size_t newest, const std::vector<Pose2>& poses,
                                      double reach_m) const;
  std::optional<Loop> close(std::size_t from, std::size_t to, const std::vector<ScanPoint>& seen,
                            const Pose2& expected, const SearchWindow& window) const;

  void thinOut();

  std::size_t most_points_;
  std::size_t points_ = 0;   ///< in all scans
  std::size_t spacing_ = 1;  ///< of the keyframes that still have theirs, but for the last
  std::vector<Keyframe> keyframes_;
  double closed_m_ = 0.0;  ///< way at the last loop
};

}  // namespace handmap
