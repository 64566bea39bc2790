#include "drivers/connected/connected_devices.h"

#include "core/base/error.h"
#include "drivers/camera/video_camera.h"

namespace handmap {

namespace {

std::unique_ptr<PairCamera> camera(const Rig& rig, RigMonitor& monitor) {
  if (!rig.camera) return nullptr;
  return std::make_unique<VideoCamera>(
      *rig.camera, monitor.clock(),
      [&monitor](const std::string& reason) { monitor.refused(reason); });
}

}  // namespace

MakeDevices connectedDevices() {
  return [](const Rig& rig, RigMonitor& monitor) {
    RigDevices devices;
    devices.camera = camera(rig, monitor);
    if (rig.scanner || rig.head || rig.odometry.isMeasured()) {
      throw Error(ErrorCode::BadInput,
                  rig.name + ": found a scanner, a head or wheels, expected a camera alone");
    }
    return devices;
  };
}

}  // namespace handmap
