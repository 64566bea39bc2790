// A live robot as any other robot of the window.
#pragma once

#include <memory>
#include <mutex>

#include "app/gui/robot.h"
#include "drivers/live/live_source.h"

namespace handmap {

/// The way from the window to the rig of the latest run. From any thread.
class LiveLink {
 public:
  /// A new drive, before its run begins.
  void begin();
  /// nullptr before the first drive.
  std::shared_ptr<RigMonitor> monitor() const;

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<RigMonitor> monitor_;
};

Robot liveRobot(const Rig& rig, MakeDevices make);
/// A laser on a simulated robot that drives through `world` in real time.
Robot virtualRobot(World world, std::uint64_t seed);

}  // namespace handmap
