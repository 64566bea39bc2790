// Odometry as a base sends it, made fit for a rig: in the rig's time, without leaps, with a word
// about how it goes.
#pragma once

#include <QString>
#include <optional>

#include "drivers/device/clock_offset.h"
#include "drivers/device/device.h"
#include "drivers/device/health.h"
#include "drivers/device/odometry_gate.h"

namespace handmap {

class OdometryStream {
 public:
  struct Moved {
    double time_s;
    Pose2 pose;
  };
  /// nullopt for what is not to be used. `pose` and `stamp_s` are finite.
  std::optional<Moved> take(double stamp_s, const Pose2& pose, double arrival_s);
  /// Something came that was no odometry.
  void refuse(const QString& why);
  /// The base is another one now, or was away: its clock may be any.
  void reconnected() { offset_ = {}; }

  /// Ready or Degraded.
  DeviceState state();
  QString detail();
  /// Of the base's frame in that of what take() gives.
  const Pose2& origin() const { return gate_.correction(); }
  int clockJumps() const { return offset_.jumps(); }
  int restarts() const { return gate_.restarts(); }

 private:
  ClockOffset offset_;
  OdometryGate gate_;
  Health health_;
  QString why_;
  double last_arrival_s_ = 0.0;
  double remark_until_s_ = 0.0;  ///< what happened lately is said for a while
};

}  // namespace handmap
