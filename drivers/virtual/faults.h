// What goes wrong in a virtual rig, and when: so that anyone can see what a live run does then.
#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/rig/rig_monitor.h"
#include "drivers/virtual/virtual_rig_kind.h"

namespace handmap {

enum class FaultKind {
  Drop,    ///< every second datum is lost
  Late,    ///< data come three seconds after they were measured
  Unplug,  ///< the device is gone, and comes back
  Freeze,  ///< the same datum over and over, with new times; on a wire: not a word
  Clock,   ///< the device's clock is off by an hour
  // Of the rig with the stereo head:
  Double,  ///< bytes come twice; Drop there: bytes are lost
  Half,    ///< the lower part of the images never comes
  Swap,    ///< left is right
  Limit,   ///< the head runs against something
  Echo,    ///< the head repeats what it hears
  Verbose  ///< the head answers in sentences
};

struct Fault {
  DeviceRole role = DeviceRole::Scanner;
  FaultKind kind = FaultKind::Drop;
  double begin_s = 0.0;  ///< of the rig's clock
  double end_s = 0.0;
};

/// "scanner:unplug@10+5,odometry:late@20+3": from second 10 for 5 s, and so on. Throws Usage, also
/// for what such a rig cannot have.
std::vector<Fault> parseFaults(std::string_view text, VirtualRigKind kind = VirtualRigKind::Laser);

/// Every fault that a device of that rig can have.
std::vector<std::pair<DeviceRole, FaultKind>> possibleFaults(VirtualRigKind kind);
const char* nameOf(FaultKind kind);

/// The first that is at work.
std::optional<FaultKind> faultAt(const std::vector<Fault>& faults, DeviceRole role, double now_s);

}  // namespace handmap
