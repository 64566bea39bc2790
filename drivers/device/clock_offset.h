// When something was measured, in the time of the rig, for devices that stamp by a clock of their
// own.
#pragma once

#include <optional>

namespace handmap {

/// What comes cannot come before it was measured, and some of it comes with hardly any delay: the
/// smallest difference between arrival and stamp of the last half minute is how far the clocks are
/// apart. Forgetting the older ones follows clocks that run at different speeds.
class ClockOffset {
 public:
  /// Seconds of the rig's clock, never after the arrival and always after what was told before;
  /// nullopt for a stamp that is repeated or out of order. `stamp_s` is finite.
  std::optional<double> rigTime(double stamp_s, double arrival_s);
  /// How often the clock of the device was set anew while it ran.
  int jumps() const { return jumps_; }

 private:
  void restart(double delay_s, double arrival_s);
  bool hasJumped(double stamp_s, double arrival_s);
  void take(double delay_s, double arrival_s);

  bool begun_ = false;
  double restart_s_ = 0.0;
  double last_stamp_s_ = 0.0;
  double last_told_s_ = 0.0;
  double smallest_s_ = 0.0;  ///< of this half minute
  double previous_s_ = 0.0;  ///< of the one before
  double half_minute_begin_s_ = 0.0;
  int late_in_a_row_ = 0;
  double late_since_s_ = 0.0;
  int jumps_ = 0;
};

}  // namespace handmap
