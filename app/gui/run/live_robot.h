// A live robot as any other robot of the window.
#pragma once

#include <memory>
#include <mutex>

#include "app/gui/run/robot.h"
#include "drivers/live/live_source.h"
#include "drivers/onlookers/onlookers.h"
#include "drivers/virtual/virtual_rig_kind.h"

namespace handmap {

/// The way from the window to the rig of the latest run, and from that run to whoever looks on.
class LiveLink : public std::enable_shared_from_this<LiveLink> {
 public:
  explicit LiveLink(Rig rig) : rig_(std::move(rig)) {}
  ~LiveLink();
  LiveLink(const LiveLink&) = delete;
  LiveLink& operator=(const LiveLink&) = delete;

  /// A new drive, before its run begins. Whoever looks on hears of it as soon as those of the drive
  /// before are told no more: an address has one owner.
  void begin();
  /// nullptr before the first drive. From any thread.
  std::shared_ptr<RigMonitor> monitor() const;
  void tell(const std::shared_ptr<const Snapshot>& snapshot);
  /// What to do, in whatever thread, where somebody who looks on says where the robot is.
  void whenPoseGiven(Onlookers::PoseGiven given);

 private:
  void exchangeOnlookers(const std::shared_ptr<RigMonitor>& monitor);
  void takePose(double time_s, const Pose2& pose) const;

  const Rig rig_;
  mutable std::mutex mutex_;
  std::shared_ptr<RigMonitor> monitor_;   // under mutex_, as all below
  std::unique_ptr<Onlookers> onlookers_;  ///< until the next drive: what was found stays to be seen
  std::shared_ptr<const Snapshot> newest_;  ///< of this drive
  Onlookers::PoseGiven given_;
  std::mutex exchanging_;  // one at a time; taken before mutex_
};

Robot liveRobot(const Rig& rig, MakeDevices make);
/// A laser, or a stereo camera that looks around at each stop, on a simulated robot that drives
/// through `world` in real time.
Robot virtualRobot(World world, std::uint64_t seed, VirtualRigKind kind);

}  // namespace handmap
