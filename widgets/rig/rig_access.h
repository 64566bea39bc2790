// What the window asks of the devices themselves; given from outside, for widgets know no drivers.
#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "core/recording/observation.h"
#include "core/rig/rig.h"
#include "core/rig/rig_monitor.h"

namespace handmap {

struct RigAccess {
  /// Opens the devices of a rig and hands on what they see, until `stop` is requested or the
  /// monitor is told to end; then closes them. Takes as long: called in a thread of its own. Throws
  /// Error.
  std::function<void(const Rig&, const std::shared_ptr<RigMonitor>&, const std::stop_token& stop,
                     const std::function<void(const Observation&)>& see)>
      host;
  /// The cameras that are connected now, as a rig names them. From any thread; may take a second.
  std::function<std::vector<std::string>(CameraKind)> cameras;
};

}  // namespace handmap
