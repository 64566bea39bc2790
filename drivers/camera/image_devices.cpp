#include "drivers/camera/image_devices.h"

#include <algorithm>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "drivers/camera/aravis_device.h"
#include "drivers/camera/iidc_device.h"
#include "drivers/camera/opencv_device.h"

namespace handmap {

namespace {

[[maybe_unused]] OpenImageDevice without(const char* library) {
  return [library]() -> std::unique_ptr<ImageDevice> {
    throw Error(ErrorCode::RunFailed,
                phrase("this program was built without {}, which such cameras need", library));
  };
}

/// Of V4L2, in order of their names.
std::vector<std::string> videoDevices() {
  std::vector<std::string> devices;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/dev", error)) {
    std::string path = entry.path().string();
    if (path.starts_with("/dev/video")) devices.push_back(std::move(path));
  }
  std::sort(devices.begin(), devices.end());
  return devices;
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

std::vector<std::string> connectedCameras(CameraKind kind) {
  if (kind == CameraKind::Video) return videoDevices();
#ifdef HANDMAP_IIDC
  if (kind == CameraKind::FireWire) return iidcCameras(*systemIidc());
#endif
#ifdef HANDMAP_ARAVIS
  if (kind == CameraKind::Vision) return aravisCameras();
#endif
  return {};
}

}  // namespace handmap
