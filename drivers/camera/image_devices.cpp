#include "drivers/camera/image_devices.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "drivers/camera/aravis_device.h"
#include "drivers/camera/iidc_device.h"
#include "drivers/camera/opencv_device.h"

namespace handmap {

namespace {

[[maybe_unused]] OpenImageDevice without(const char* library) {
  return [library]() -> std::unique_ptr<ImageDevice> {
    throw Error(ErrorCode::RunFailed,
                fmt::format("this program was built without {}, which such cameras need", library));
  };
}

}  // namespace

OpenImageDevice imageDevice(const CameraRig& rig, const std::string& source, RigClock clock,
                            double begin_s) {
  switch (rig.kind) {
    case CameraKind::FireWire:
#ifdef HANDMAP_IIDC
      return iidcDevice(source, systemIidc, std::move(clock));
#else
      return without("libdc1394");
#endif
    case CameraKind::Vision:
#ifdef HANDMAP_ARAVIS
      return aravisDevice({source, rig.width, rig.height, rig.rate_hz}, std::move(clock));
#else
      return without("Aravis");
#endif
    case CameraKind::Video:
    case CameraKind::Virtual:
      break;
  }
  return opencvDevice({source, rig.width, rig.height, rig.rate_hz, begin_s}, std::move(clock));
}

std::vector<std::string> connectedCameras([[maybe_unused]] CameraKind kind) {
#ifdef HANDMAP_IIDC
  if (kind == CameraKind::FireWire) return iidcCameras(*systemIidc());
#endif
#ifdef HANDMAP_ARAVIS
  if (kind == CameraKind::Vision) return aravisCameras();
#endif
  return {};
}

}  // namespace handmap
