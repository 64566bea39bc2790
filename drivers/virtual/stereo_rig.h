// The paper's robot without any of it: a stereo camera on a pan-tilt head that stops and looks
// around. The images are rendered, head and wheels are emulated behind pseudo-terminals: what the
// program does with them is what it does with real ones.
#pragma once

#include "drivers/virtual/virtual_rig.h"

namespace handmap {

Rig virtualStereoRig();

/// Throws BadInput where the world has no way to drive.
MakeDevices virtualStereoDevices(VirtualDrive drive);

}  // namespace handmap
