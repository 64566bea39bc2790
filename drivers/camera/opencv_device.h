// What OpenCV's VideoCapture opens: /dev/video0, a video file, the URL of a network camera.
#pragma once

#include <string>

#include "core/rig/rig_clock.h"
#include "drivers/camera/image_device.h"

namespace handmap {

struct CaptureOptions {
  std::string source;
  int width = 0;  ///< 0: as it likes
  int height = 0;
  double rate_hz = 0.0;
  double begin_s = 0.0;  ///< of the rig's clock: when a video file begins to play
};

/// A video file is played at its own rate, and its images have the times at which they were due:
/// those of two files that begin together make pairs.
OpenImageDevice opencvDevice(CaptureOptions options, RigClock clock);

}  // namespace handmap
