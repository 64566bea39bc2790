// How probably a stated pose is right.
#pragma once

#include <Eigen/Core>

#include "core/method/snapshot.h"

namespace handmap {

/// Probability that what has this covariance (metres²) around where it is stated is off by no more
/// than a distance.
double probabilityWithin(const Eigen::Matrix2d& covariance, double distance_m);

/// How far what has this covariance is off at most with this probability, metres.
double radiusHolding(const Eigen::Matrix2d& covariance, double probability);

/// Of the stated position, square metres.
Eigen::Matrix2d positionCovariance(const FrameReport& report);
/// Nine times of ten the stated position is off by no more, metres: what line, chart and status
/// say.
double certainWithin(const FrameReport& report);

/// (x, y, heading) of the stated pose, as far as a report has it.
Eigen::Matrix3d poseCovariance(const FrameReport& report);

/// Of a robot that nothing has told anything of for so long: it may have walked off.
void stateBlind(double blind_s, FrameReport& report);

/// Writes pose_sigma and within.
void stateTrust(const Eigen::Matrix3d& covariance, FrameReport& report);

/// How surely the robot is where it is shown.
enum class Certainty { Sure, Rough, Lost };

/// Nine times of ten the pose is off by no more than `within_m` and `heading_rad`: by itself, which
/// is not sure where nothing of the drawing was recognised for long.
struct PoseCertainty {
  Certainty kind;
  double within_m;
  double heading_rad;
};
PoseCertainty certaintyOf(const FrameReport& report);

/// How sure a building is whose walls were seen.
struct BuildingTrust {
  std::size_t building;           ///< of the drawing
  std::array<double, 4> sigma_m;  ///< of the sides of its box: ahead, left, behind, right
  double within;                  ///< probability that a side is off by no more than its σ
};

/// Of the buildings of a corrected map whose walls were seen.
std::vector<BuildingTrust> trustOf(const Map& refined);

}  // namespace handmap
