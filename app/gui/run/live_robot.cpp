#include "app/gui/run/live_robot.h"

#include <QDateTime>
#include <QObject>

#include "drivers/virtual/stereo_rig.h"
#include "widgets/background/background.h"

namespace handmap {

namespace {

/// Each drive gets a folder of its own.
std::filesystem::path newFolder(const std::filesystem::path& inside) {
  if (inside.empty()) return {};
  return inside / QDateTime::currentDateTime().toString("yyyyMMdd-HHmmss").toStdString();
}

}  // namespace

LiveLink::~LiveLink() { endTelling(); }

void LiveLink::begin() {
  endTelling();
  const std::scoped_lock lock(mutex_);
  monitor_ = std::make_shared<RigMonitor>();
  onlookers_ = Onlookers::of(rig_, monitor_);
}

/// It waits for the last messages to leave, which the window may not.
void LiveLink::endTelling() {
  if (onlookers_) startInBackground([onlookers = std::exchange(onlookers_, nullptr)] {});
}

void LiveLink::tell(const std::shared_ptr<const Snapshot>& snapshot) {
  if (onlookers_) onlookers_->tell(snapshot);
}

std::shared_ptr<RigMonitor> LiveLink::monitor() const {
  const std::scoped_lock lock(mutex_);
  return monitor_;
}

Robot liveRobot(const Rig& rig, MakeDevices make) {
  Robot robot;
  robot.name = QString::fromStdString(rig.name);
  robot.opening = QObject::tr("Waiting for the robot");
  robot.live = std::make_shared<LiveLink>(rig);
  robot.connect = [rig, make = std::move(make), link = robot.live](
                      const ReplayOptions&, const std::stop_token& stop,
                      const std::function<void(double)>&) {
    return openLive({rig, make, link->monitor(), newFolder(rig.record)}, stop);
  };
  return robot;
}

Robot virtualRobot(World world, std::uint64_t seed, VirtualRigKind kind) {
  const Map truth = world.map;
  VirtualDrive drive;
  drive.world = std::move(world);
  drive.seed = seed;
  const bool stereo = kind == VirtualRigKind::StereoHead;
  const Rig rig = stereo ? virtualStereoRig() : virtualRig(drive);
  Robot robot = liveRobot(
      rig, stereo ? virtualStereoDevices(std::move(drive)) : virtualDevices(std::move(drive)));
  robot.name = QObject::tr("Virtual rig");
  robot.truth_map = truth;
  return robot;
}

}  // namespace handmap
