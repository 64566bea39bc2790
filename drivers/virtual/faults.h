// What goes wrong in a virtual rig, and when: so that anyone can see what a live run does then.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "drivers/live/rig_monitor.h"

namespace handmap {

enum class FaultKind {
  Drop,    ///< every second datum is lost
  Late,    ///< data come three seconds after they were measured
  Unplug,  ///< the device is gone, and comes back
  Freeze,  ///< the same datum over and over, with new times
  Clock    ///< the device's clock is off by an hour
};

struct Fault {
  DeviceRole role = DeviceRole::Scanner;
  FaultKind kind = FaultKind::Drop;
  double begin_s = 0.0;  ///< of the rig's clock
  double end_s = 0.0;
};

/// "scanner:unplug@10+5,odometry:late@20+3": from second 10 for 5 s, and so on. Throws Usage.
std::vector<Fault> parseFaults(std::string_view text);

/// The first that is at work.
std::optional<FaultKind> faultAt(const std::vector<Fault>& faults, DeviceRole role, double now_s);

}  // namespace handmap
