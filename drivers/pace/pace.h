// How fast a source is released: a multiple of the clock of its recording. Shared between the
// thread that reads and the thread where somebody turns the knob.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>

namespace handmap {

class Pace {
 public:
  using Clock = std::chrono::steady_clock;

  /// 1 is the speed of the recording; 0 (or less) is as fast as possible.
  explicit Pace(double speed) : speed_(speed) {}

  /// Takes effect at once, also for who is waiting.
  void setSpeed(double speed);

  /// Waits until `seconds` of the recording have passed since `since`; returns at once when `stop`
  /// is requested.
  void waitFor(double seconds, Clock::time_point since, const std::stop_token& stop);

 private:
  std::mutex mutex_;
  std::condition_variable_any changed_;
  double speed_;
};

}  // namespace handmap
