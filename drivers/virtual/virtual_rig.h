// A rig that anyone has: a laser scanner and wheels in a simulated world, behind the same
// interfaces as real devices.
#pragma once

#include "core/simulation/simulated_source.h"
#include "core/simulation/world.h"
#include "drivers/live/rig_devices.h"
#include "drivers/virtual/faults.h"

namespace handmap {

struct VirtualDrive {
  World world;
  std::uint64_t seed = 1;
  double speed_m_s = 2.0;
  double step_m = 0.4;  ///< between two scans
  std::vector<Fault> faults = {};
};

/// Scanner and odometry, both virtual.
Rig virtualRig(const VirtualDrive& drive);

/// The robot starts when the first of its devices is opened, and stands at the end of its route.
/// Throws BadInput where the world has no way to drive.
MakeDevices virtualDevices(VirtualDrive drive);

}  // namespace handmap
