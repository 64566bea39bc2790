// How far a measured motion is off.
#pragma once

#include <Eigen/Core>

#include "core/recording/odometry.h"

namespace handmap {

/// Of a step of odometry, one σ. What grows with the length of the way grows with its heading's
/// variance; the rest in proportion.
struct OdometryNoise {
  double along_per_m;
  double aside_per_m;
  double least_m;
  double heading_variance_per_m;  ///< radians²
  double heading_per_rad;         ///< of a turn
  double least_heading;           ///< radians

  bool operator==(const OdometryNoise&) const = default;
  /// Of (along, aside, heading).
  Eigen::Vector3d sigmaOf(const Pose2& motion) const;
};

/// Of the motion between two poses: what was guessed of it, beside its noise, in the frame of
/// `from`: (along, aside, heading).
Eigen::Matrix3d guessedOf(const Odometry& from, const Odometry& to);

/// Whether what was guessed may be as much as what is driven between two keyframes.
bool mayBeFar(const Eigen::Matrix3d& guessed);

/// What becomes of motions that are guessed, at the speed of before: the longer nothing holds them,
/// the less that speed says.
class Guess {
 public:
  enum class Of { Along, All };

  /// A motion of so many seconds: along one direction alone (a unit vector of the odometry frame),
  /// or all of it.
  void goOn(double elapsed_s, Of what, const Vec2& along = {});
  /// Measured again: the next guess starts anew from its speed.
  void hold() {
    since_s_ = 0.0;
    knows_speed_ = true;
  }

  /// As Odometry has it.
  const Eigen::Matrix3d& variance() const { return variance_; }
  /// One σ of what was guessed since it was last held, metres.
  double off_m() const;

 private:
  double since_s_ = 0.0;
  bool knows_speed_ = false;
  Eigen::Matrix3d variance_ = Eigen::Matrix3d::Zero();
};

}  // namespace handmap
