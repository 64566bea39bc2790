// One camera (or video file, or network stream) of OpenCV's VideoCapture, in a thread of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <thread>

#include "drivers/camera/pair_matcher.h"
#include "drivers/device/rig_clock.h"

namespace handmap {

struct GrabberOptions {
  std::string source;  ///< "/dev/video0", a file, a URL
  int width = 0;       ///< 0: as it likes
  int height = 0;
  double rate_hz = 0.0;
  std::uint64_t seed = 1;  ///< of the times between attempts to open it
};

/// Grabs until it is destroyed; opens what was lost again. A video file is played at its own rate
/// once. Both listeners are called in its thread.
class FrameGrabber {
 public:
  enum class State { Opening, Delivering, Lost, AtEnd };
  using FrameListener = std::function<void(TimedImage)>;
  using StateListener = std::function<void(State, const std::string& detail)>;

  FrameGrabber(GrabberOptions options, RigClock clock, FrameListener on_frame,
               StateListener on_state);

 private:
  void work(const std::stop_token& stop);
  bool grabAll(const std::stop_token& stop);

  GrabberOptions options_;
  RigClock clock_;
  FrameListener on_frame_;
  StateListener on_state_;
  std::jthread thread_;  // last: it ends first
};

}  // namespace handmap
