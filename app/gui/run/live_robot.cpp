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

/// They wait for the last messages to leave, which the window may not.
LiveLink::~LiveLink() {
  if (!onlookers_) return;
  startInBackground([onlookers = std::shared_ptr(std::move(onlookers_))] {});
}

void LiveLink::begin() {
  auto monitor = std::make_shared<RigMonitor>();
  {
    const std::scoped_lock lock(mutex_);
    monitor_ = monitor;
    newest_ = nullptr;
  }
  startInBackground([weak = weak_from_this(), monitor = std::move(monitor)] {
    if (const auto self = weak.lock()) self->exchangeOnlookers(monitor);
  });
}

void LiveLink::exchangeOnlookers(const std::shared_ptr<RigMonitor>& monitor) {
  const std::scoped_lock exchanging(exchanging_);
  std::unique_ptr<Onlookers> before;
  {
    const std::scoped_lock lock(mutex_);
    if (monitor != monitor_) return;  // the next drive has begun meanwhile
    before = std::move(onlookers_);
  }
  before.reset();
  auto onlookers =
      Onlookers::of(rig_, monitor, [weak = weak_from_this()](double time_s, const Pose2& pose) {
        if (const auto self = weak.lock()) self->takePose(time_s, pose);
      });
  const std::scoped_lock lock(mutex_);
  onlookers_ = std::move(onlookers);
  if (onlookers_ && newest_) onlookers_->tell(newest_);
}

void LiveLink::whenPoseGiven(Onlookers::PoseGiven given) {
  const std::scoped_lock lock(mutex_);
  given_ = std::move(given);
}

void LiveLink::takePose(double time_s, const Pose2& pose) const {
  const std::scoped_lock lock(mutex_);
  if (given_) given_(time_s, pose);
}

void LiveLink::tell(const std::shared_ptr<const Snapshot>& snapshot) {
  const std::scoped_lock lock(mutex_);
  newest_ = snapshot;
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
