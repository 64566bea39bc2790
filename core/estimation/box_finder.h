// Buildings from walls and rays, without the drawing.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "core/estimation/box_score.h"
#include "core/estimation/wall_detection.h"

namespace handmap {

/// A building that was found: the box that explains the rays best.
struct FoundBox {
  Box box;
  double score = 0.0;  ///< log ratio against nothing there
  /// Of box.reach; large where a wall was not seen. Walls share the errors of the robot's poses.
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  double heading_sigma = 0.0;
  int observations = 0;  ///< frames that saw it
  bool in_sight = true;  ///< of the last frame; others stay as they are
  /// Numbers of the frames that may have seen it.
  std::size_t first_frame = 0;
  std::size_t last_frame = std::numeric_limits<std::size_t>::max();
  /// Out of sight for long: the way may have drifted since.
  bool asleep = false;

  /// Whether it was found before any of the frames: there is more to know of it than they tell.
  bool predates(std::span<const Frame* const> frames) const;

  double reachSigma(std::size_t wall) const {
    const auto k = static_cast<Eigen::Index>(wall);
    return std::sqrt(covariance(k, k));
  }
  /// Of a wall that was found by other means: it shares nothing with the others.
  void setReachSigma(std::size_t wall, double sigma);
  FoundBox nearestTo(double heading_rad) const;  ///< as Box::nearestTo()
};

struct FinderOptions {
  double least_score = 40.0;     ///< nats; less is no building
  double typical_size_m = 15.0;  ///< of sides that nobody saw
  double least_size_m = 2.5;
};

/// Keeps a list of buildings up to date with walls detected in the evidence and with the rays
/// themselves.
class BoxFinder {
 public:
  explicit BoxFinder(const FinderOptions& options) : options_(options) {}

  /// Changes and drops boxes in sight and adds new ones. `frames`: the last ones, back to those
  /// that saw the first of what is in sight.
  void update(std::vector<FoundBox>& boxes, const std::vector<FoundWall>& walls,
              std::span<const Frame* const> frames, const SensorModel& sensor);
  /// Local search of the box that explains the rays best; `step_m` is how far it looks at first.
  void refine(FoundBox& found, double step_m, std::span<const Frame* const> frames,
              const SensorModel& sensor) const;
  /// Puts the best of some boxes in the place of `boxes[at]`, where it explains the rays better
  /// than that and what else stands there. Returns whether it did; then prune() is due.
  bool replace(std::vector<FoundBox>& boxes, std::size_t at, std::span<const Box> candidates,
               std::span<const Frame* const> frames, const SensorModel& sensor) const;
  /// Of boxes that cannot both be the surer stays. The other one comes back when that is given up.
  void prune(std::vector<FoundBox>& boxes);
  /// Finds the walls that no returns are from (rear walls, behind which there is free space) where
  /// the rays tell them, and says how well they are known.
  void locateUnseen(FoundBox& found, std::span<const Frame* const> frames,
                    const SensorModel& sensor) const;

 private:
  double objective(const Box& box, BoxScorer& scorer) const;
  bool adopt(FoundBox& found, const FoundWall& wall, std::span<const Frame* const> frames,
             const SensorModel& sensor) const;
  /// The pieces of a box whose walls were found apart, where they explain the rays better.
  std::vector<FoundBox> split(const FoundBox& found, const std::vector<FoundWall>& walls,
                              std::span<const Frame* const> frames,
                              const SensorModel& sensor) const;
  Box seed(const FoundWall& wall) const;

  FinderOptions options_;
  std::vector<FoundBox> rivals_;  ///< where a surer box stands
};

}  // namespace handmap
