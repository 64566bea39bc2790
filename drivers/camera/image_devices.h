// The camera that a rig names, by whatever it is connected.
#pragma once

#include "core/rig/rig.h"
#include "core/rig/rig_clock.h"
#include "drivers/camera/image_device.h"

namespace handmap {

/// `source`: the left or the right one of the rig; `begin_s`: see CaptureOptions. A kind that this
/// program was built without cannot be opened, and says so.
OpenImageDevice imageDevice(const CameraRig& rig, const std::string& source, RigClock clock,
                            double begin_s);

/// Those that are connected now, as a rig names them; asking may take a second.
std::vector<std::string> connectedCameras(CameraKind kind);

}  // namespace handmap
