#include "drivers/device/clock_offset.h"

#include <algorithm>
#include <limits>

namespace handmap {

namespace {

constexpr double kWindow_s = 30.0;
/// More than clocks drift apart between two messages, less than a person would call a jump.
constexpr double kJump_s = 0.3;
/// Messages of a network may overtake each other by so much.
constexpr double kDisorder_s = 0.05;
/// The first messages may have waited somewhere until somebody listened.
constexpr double kSettle_s = 2.0;
constexpr double kLongestWait_s = 5.0;
/// A delay that stays is no delay: the clock was set back by less than the time between messages.
/// What had to wait somewhere comes in a burst, however much it is.
constexpr int kLateInARow = 10;
constexpr double kLateFor_s = 2.0;

}  // namespace

std::optional<double> ClockOffset::rigTime(double stamp_s, double arrival_s) {
  const double delay_s = arrival_s - stamp_s;
  if (!begun_) {
    begun_ = true;
    last_told_s_ = -std::numeric_limits<double>::infinity();
    restart(delay_s, arrival_s);
  } else if (hasJumped(stamp_s, arrival_s)) {
    ++jumps_;
    restart(delay_s, arrival_s);
  } else if (stamp_s <= last_stamp_s_) {
    return std::nullopt;
  } else {
    take(delay_s, arrival_s);
  }
  last_stamp_s_ = stamp_s;
  const double time_s = stamp_s + std::min(smallest_s_, previous_s_);
  if (time_s <= last_told_s_) return std::nullopt;
  last_told_s_ = time_s;
  return time_s;
}

void ClockOffset::restart(double delay_s, double arrival_s) {
  smallest_s_ = previous_s_ = delay_s;
  half_minute_begin_s_ = restart_s_ = arrival_s;
  late_in_a_row_ = 0;
}

bool ClockOffset::hasJumped(double stamp_s, double arrival_s) {
  const double delay_s = arrival_s - stamp_s;
  const double offset_s = std::min(smallest_s_, previous_s_);
  if (stamp_s < last_stamp_s_ - kDisorder_s) return true;
  if (delay_s < offset_s - kJump_s) {
    return arrival_s - restart_s_ > kSettle_s || delay_s < offset_s - kLongestWait_s;
  }
  if (delay_s < offset_s + kJump_s) {
    late_in_a_row_ = 0;
    return false;
  }
  if (late_in_a_row_++ == 0) late_since_s_ = arrival_s;
  return late_in_a_row_ >= kLateInARow && arrival_s - late_since_s_ > kLateFor_s;
}

void ClockOffset::take(double delay_s, double arrival_s) {
  if (arrival_s - half_minute_begin_s_ > kWindow_s) {
    previous_s_ = smallest_s_;
    smallest_s_ = delay_s;
    half_minute_begin_s_ = arrival_s;
  }
  smallest_s_ = std::min(smallest_s_, delay_s);
}

}  // namespace handmap
