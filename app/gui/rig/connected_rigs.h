// The devices of rigs, for the dialogs that try and calibrate them.
#pragma once

#include "drivers/live/rig_devices.h"
#include "widgets/rig/rig_access.h"

namespace handmap {

RigAccess rigAccess(MakeDevices make);

}  // namespace handmap
