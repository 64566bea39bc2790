// Whoever looks on is told of a run: ROS over rosbridge, Foxglove by a server of our own.
#pragma once

#include <QThread>
#include <memory>

#include "core/rig/rig.h"
#include "core/rig/rig_monitor.h"
#include "core/session/snapshot.h"

namespace handmap {

/// Works in a thread of its own. How it stands is told by the monitor, as that of devices is; what
/// goes wrong here never ends a run. Needs a QCoreApplication in the process.
class Onlookers {
 public:
  /// nullptr where the rig has none.
  static std::unique_ptr<Onlookers> of(const Rig& rig, std::shared_ptr<RigMonitor> monitor);
  /// Waits until what was told last has left and all is closed: some tenths of a second.
  ~Onlookers();
  Onlookers(const Onlookers&) = delete;
  Onlookers& operator=(const Onlookers&) = delete;

  /// From any thread; returns at once. The newest is told: its pose at once, its map once a second.
  void tell(std::shared_ptr<const Snapshot> snapshot);

 private:
  class Telling;
  Onlookers(const Rig& rig, std::shared_ptr<RigMonitor> monitor);

  QThread thread_;
  std::unique_ptr<Telling> telling_;  ///< lives in the thread
};

}  // namespace handmap
