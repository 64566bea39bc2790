// Whoever looks on is told of a run: ROS over rosbridge, Foxglove by a server of our own.
#pragma once

#include <QThread>
#include <functional>
#include <memory>

#include "core/method/snapshot.h"
#include "core/rig/rig.h"
#include "core/rig/rig_monitor.h"

namespace handmap {

/// Works in a thread of its own. How it stands is told by the monitor, as that of devices is; what
/// goes wrong here never ends a run. Needs a QCoreApplication in the process.
class Onlookers {
 public:
  /// Somebody there says where the robot is (ROS: /initialpose); told in any thread. Seconds of the
  /// rig's clock: of the observation that was told last.
  using PoseGiven = std::function<void(double time_s, const Pose2& pose)>;

  /// nullptr where the rig has none.
  static std::unique_ptr<Onlookers> of(const Rig& rig, std::shared_ptr<RigMonitor> monitor,
                                       PoseGiven given = {});
  /// Waits until what was told last has left and all is closed: some tenths of a second.
  ~Onlookers();
  Onlookers(const Onlookers&) = delete;
  Onlookers& operator=(const Onlookers&) = delete;

  /// From any thread; returns at once. The newest is told: its pose at once, its map once a second
  /// at most, and the frames so often that navigation can go by them, while the robot is not lost.
  void tell(std::shared_ptr<const Snapshot> snapshot);

 private:
  class Telling;
  Onlookers(const Rig& rig, std::shared_ptr<RigMonitor> monitor, PoseGiven given);

  QThread thread_;
  std::unique_ptr<Telling> telling_;  ///< lives in the thread
};

}  // namespace handmap
