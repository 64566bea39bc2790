// Least squares over poses, found buildings, compact things and how the drawing lies.
#pragma once

#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/estimation/smoothing/odometry_factor.h"
#include "core/estimation/smoothing/prior_factors.h"
#include "core/estimation/smoothing/sight_factors.h"
#include "core/estimation/smoothing/smoothing_graph.h"
#include "core/pose_graph/normal_equations.h"

namespace handmap {

/// Gauss-Newton with weights that follow the sensor model. What a frame says of a wall is each
/// return's distance from it; what it says of the end of a building is the bearing at which the
/// returns of the building stop. README.md has all residuals.
class Smoother {
 public:
  Smoother(const OdometryNoise& odometry, const SensorModel& sensor)
      : odometry_(odometry), sensor_(sensor) {}

  /// How far, across a wall, what one frame says of it is off as a whole, one σ: walls are not
  /// quite straight and poses of moving robots not quite those of the scan. Its ends are off by
  /// more.
  void setSystematic(double sigma_m) { systematic_m_ = sigma_m; }
  /// Variance of the odometry's heading after a metre, radians².
  void setHeadingVariance(double per_m) { odometry_.heading_variance_per_m = per_m; }
  void expectHeadings(HeadingPrior prior) { headings_ = std::move(prior); }
  /// What the ranges are off systematically, see RangeNoise, is estimated with all the rest.
  double biasPerMetre() const { return bias_per_m_; }
  /// And so is what the lengths of the odometry are off: the motion as it was.
  Pose2 scaled(const Pose2& motion) const { return handmap::scaled(motion, scale_); }
  /// Moves the poses, the boxes and the landmarks that the frames saw. `slack_m` (across a wall,
  /// one σ) is what poses and boxes may be off before: wide to catch, narrow to settle.
  /// Returns how far the pose that moved most did, metres. Nothing moves when `stop` was requested,
  /// or where the equations have no solution.
  double iterate(const SmoothingGraph& graph, double slack_m, const std::stop_token& stop = {});
  /// After a whole iterate(): writes the σ of the boxes and returns the covariance of the last
  /// pose. nullopt, and nothing written, where that found no solution.
  std::optional<Eigen::Matrix3d> covariances(std::span<FoundBox> boxes) const;

 private:
  void addOdometry(const SmoothingGraph& graph, NormalEquations& equations) const;
  /// Returns how many frames saw each of the boxes.
  std::vector<int> addBuildings(const SmoothingGraph& graph, double slack_m,
                                const std::stop_token& stop, NormalEquations& equations) const;
  void addHeadings(const SmoothingGraph& graph, NormalEquations& equations) const;
  void addLandmarks(const SmoothingGraph& graph, NormalEquations& equations) const;
  void addCalibration(std::span<Frame* const> frames, NormalEquations& equations) const;
  double update(const SmoothingGraph& graph, const Eigen::VectorXd& step);

  OdometryNoise odometry_;
  double systematic_m_ = 0.03;  ///< until it is measured
  double bias_per_m_ = 0.0;
  double scale_ = 0.0;  ///< of the odometry, less 1
  HeadingPrior headings_;
  const SensorModel& sensor_;
  StateLayout layout_;  ///< of the last iterate()
  NormalSolver solver_;
};

}  // namespace handmap
