// The real devices that a rig names.
#pragma once

#include "drivers/live/rig_devices.h"

namespace handmap {

MakeDevices connectedDevices();

}  // namespace handmap
