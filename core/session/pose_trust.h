// How probably a stated pose is right.
#pragma once

#include <Eigen/Core>

#include "core/session/snapshot.h"

namespace handmap {

/// Probability that what has this covariance (metres²) around where it is stated is off by no more
/// than a distance.
double probabilityWithin(const Eigen::Matrix2d& covariance, double distance_m);

/// How far what has this covariance is off at most with this probability, metres.
double radiusHolding(const Eigen::Matrix2d& covariance, double probability);

/// Of the stated position, square metres.
Eigen::Matrix2d positionCovariance(const FrameReport& report);

/// Writes pose_sigma and within.
void stateTrust(const Eigen::Matrix3d& covariance, FrameReport& report);

/// Sure enough to drive by; only roughly known; not to be driven by.
enum class PoseState { Sure, Unsure, Lost };
PoseState poseState(const FrameReport& report);

/// How sure a building is whose walls were seen.
struct BuildingTrust {
  std::size_t building;           ///< of the drawing
  std::array<double, 4> sigma_m;  ///< of the sides of its box: ahead, left, behind, right
  double within;                  ///< probability that a side is off by no more than its σ
};

/// Of the buildings of a corrected map whose walls were seen.
std::vector<BuildingTrust> trustOf(const Map& refined);

}  // namespace handmap
