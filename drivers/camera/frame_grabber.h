// One camera in a thread of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <thread>

#include "drivers/camera/image_device.h"

namespace handmap {

/// Grabs until it is destroyed; opens what was lost again. A video is played once. Both listeners
/// are called in its thread.
class FrameGrabber {
 public:
  enum class State { Opening, Delivering, Lost, AtEnd };
  using FrameListener = std::function<void(TimedImage)>;
  using StateListener = std::function<void(State, const std::string& detail)>;

  /// `name` stands for the camera in what is told; `seed`: of the times between two attempts.
  FrameGrabber(std::string name, OpenImageDevice open, std::uint64_t seed, FrameListener on_frame,
               StateListener on_state);

 private:
  enum class Outcome { Nothing, Delivered, AtEnd };
  void work(const std::stop_token& stop);
  Outcome grabAll(const std::stop_token& stop);

  std::string name_;
  OpenImageDevice open_;
  std::uint64_t seed_;
  FrameListener on_frame_;
  StateListener on_state_;
  std::jthread thread_;  // last: it ends first
};

}  // namespace handmap
