#include "drivers/pace/pace.h"

#include <algorithm>

namespace handmap {

namespace {
/// A gap in a recording is not waited out longer than this.
constexpr double kLongestWaitSeconds = 60.0;
}  // namespace

void Pace::setSpeed(double speed) {
  {
    const std::scoped_lock lock(mutex_);
    speed_ = speed;
  }
  changed_.notify_all();
}

void Pace::waitFor(double seconds, Clock::time_point since, const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (speed_ > 0.0 && !stop.stop_requested()) {
    const double speed = speed_;
    const auto due =
        since + std::chrono::duration_cast<Clock::duration>(
                    std::chrono::duration<double>(std::min(seconds / speed, kLongestWaitSeconds)));
    const bool turned =
        changed_.wait_until(lock, stop, due, [this, speed] { return speed_ != speed; });
    if (!turned) return;
  }
}

}  // namespace handmap
