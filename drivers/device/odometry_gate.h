// Poses of a base that no robot can have had are held back; a base that starts anew goes on where
// it was.
#pragma once

#include <optional>

#include "core/geometry/pose2.h"

namespace handmap {

/// Faster than any robot that is meant here, so that only what is wrong is held back.
struct OdometryLimits {
  double speed = 30.0;      ///< metres a second
  double turn_rate = 20.0;  ///< radians a second
};

class OdometryGate {
 public:
  explicit OdometryGate(OdometryLimits limits = {}) : limits_(limits) {}

  /// The pose in an odometry frame without leaps; nullopt for a leap that the next pose has yet to
  /// confirm. A leap that is confirmed is a base that began at another place: of the motion in
  /// between nothing is known, it is taken as none.
  std::optional<Pose2> pass(double time_s, const Pose2& pose);

  /// Of the base's frame in the one without leaps.
  const Pose2& correction() const { return correction_; }
  int heldBack() const { return held_back_; }  ///< confirmed ones not counted
  int restarts() const { return restarts_; }

 private:
  struct Told {
    double time_s;
    Pose2 pose;
  };
  bool reachable(const Told& from, double time_s, const Pose2& pose) const;

  OdometryLimits limits_;
  std::optional<Told> last_;  ///< as the base told it
  std::optional<Told> leap_;
  Pose2 correction_;  ///< from the base's frame to the one without leaps
  int held_back_ = 0;
  int restarts_ = 0;
};

}  // namespace handmap
