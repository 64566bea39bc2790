// A camera that is not there: what it would see from where the robot is and its head looks.
#pragma once

#include <memory>
#include <mutex>

#include "core/rendering/renderer.h"
#include "core/rig/rig_clock.h"
#include "drivers/camera/image_device.h"
#include "drivers/virtual/faults.h"

namespace handmap {

/// Where the camera is, told by the thread of the rig, asked by that of the camera.
class CameraPlace {
 public:
  struct At {
    Pose2 robot;       ///< map frame
    double pan = 0.0;  ///< radians
    double time_s = 0.0;
  };
  void tell(const At& at);
  At now() const;

 private:
  mutable std::mutex mutex_;
  At at_;
};

struct RenderedCamera {
  World world;
  RenderOptions rendering;
  std::uint64_t seed = 1;
  double rate_hz = 4.0;  ///< at most: rendering takes its time
  std::vector<Fault> faults = {};
};

/// Both images side by side.
OpenImageDevice renderedDevice(RenderedCamera camera, std::shared_ptr<CameraPlace> place,
                               RigClock clock);

}  // namespace handmap
