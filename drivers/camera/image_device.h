// One camera (or video file, or network stream), whatever it is connected by.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

#include "drivers/camera/pair_matcher.h"

namespace handmap {

/// Lives and is used in the thread of its grabber only; closed when it goes.
class ImageDevice {
 public:
  virtual ~ImageDevice() = default;

  /// Waits for the next image: 8 bit, one or three channels. nullopt: no more come, or `stop` was
  /// requested. Throws Error, in plain words, for what cannot be used.
  virtual std::optional<TimedImage> next(const std::stop_token& stop) = 0;
  /// A video: after its last image it is not tried again.
  virtual bool hasEnd() const { return false; }
};

/// Throws Error, in plain words, where it cannot be opened.
using OpenImageDevice = std::function<std::unique_ptr<ImageDevice>()>;

/// Waits until `stop` is requested, but not longer than that.
void waitFor(double seconds, const std::stop_token& stop);

}  // namespace handmap
