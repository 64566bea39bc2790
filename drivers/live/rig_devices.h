// The devices of one rig, made in its thread.
#pragma once

#include <functional>
#include <memory>

#include "core/rig/rig.h"
#include "core/rig/rig_monitor.h"
#include "drivers/device/device.h"

namespace handmap {

/// Those that the rig has.
struct RigDevices {
  std::unique_ptr<OdometrySensor> odometry;
  std::unique_ptr<RangeSensor> scanner;
  std::unique_ptr<PairCamera> camera;
  std::unique_ptr<PanTiltHead> head;
};

/// Called in the thread where they will live. They take the time of `monitor` and tell it what they
/// could not use; it outlives them. Throws Error for what cannot be, e.g. an address that
/// is none.
using MakeDevices = std::function<RigDevices(const Rig&, RigMonitor& monitor)>;

}  // namespace handmap
