#include "drivers/virtual/stereo_rig.h"

#include <QTimer>
#include <cmath>

#include "core/simulation/drive.h"
#include "drivers/camera/video_camera.h"
#include "drivers/emulators/odometry_emulator.h"
#include "drivers/emulators/ptu_emulator.h"
#include "drivers/odometry_lines/line_odometry.h"
#include "drivers/pan_tilt/ptu_head.h"
#include "drivers/virtual/rendered_device.h"
#include "drivers/virtual/stop_and_go.h"

namespace handmap {

namespace {

constexpr int kTick_ms = 20;
constexpr double kStop_m = 5.0;
constexpr double kHaste = 2.0;  // a head of this family can; it is not set to it
constexpr double kAway = 0.1;   // rad: the head does not look ahead
constexpr double kRange_m = 30.0;
constexpr double kClockJump_s = 3600.0;
/// Of the bytes: some lines a second are damaged.
constexpr double kDamaged = 0.02;
constexpr int kLate_ms = 3000;

RenderOptions cameraOptions() {
  RenderOptions options;
  options.width = 480;  // three quarters of the demonstration's: it has to be rendered in time
  options.height = 360;
  return options;
}

SimulationOptions wheels(const VirtualDrive& drive) {
  SimulationOptions options = atStep({}, kStop_m);
  options.speed_m_s = drive.speed_m_s;
  return options;
}

/// What becomes of a wire; nullopt: it is well.
void damage(EmulatedPort& port, std::optional<FaultKind> fault) {
  WireFaults wire;
  if (fault == FaultKind::Drop) wire.dropped = kDamaged;
  if (fault == FaultKind::Double) wire.doubled = kDamaged;
  if (fault == FaultKind::Late) wire.delay_ms = kLate_ms;
  port.setFaults(wire);
  if (fault == FaultKind::Unplug) {
    port.unplug();
  } else {
    port.plug();
  }
}

/// The robot, its head and its base; lives with them in the thread of the rig.
class StereoRobot : public QObject {
 public:
  StereoRobot(const VirtualDrive& drive, RigClock clock)
      : faults_(drive.faults),
        clock_(std::move(clock)),
        robot_(driven(drive)),
        place_(std::make_shared<CameraPlace>()),
        head_(EmulatedPort::Kind::PseudoTerminal, kHaste, drive.seed),
        base_(
            EmulatedPort::Kind::PseudoTerminal, [this](double) { return robot_.odometry(); },
            OdometryEmulator::Form::FieldsWithChecksum, kTick_ms, drive.seed + 1) {
    tell();
    connect(&timer_, &QTimer::timeout, this, [this] { tick(); });
    timer_.start(kTick_ms);
  }

  std::shared_ptr<CameraPlace> place() const { return place_; }
  std::string headPort() { return head_.port().address(); }
  std::string basePort() { return base_.port().address(); }

 private:
  static StopAndGo driven(const VirtualDrive& drive) {
    Drive way = driveThrough(drive.world.map, wheels(drive), drive.seed);
    return {std::move(way.truth), std::move(way.odometry)};
  }

  double pan() { return toRadians(head_.pan().position * head_.pan().resolution_arcsec / 3600.0); }

  void tell() { place_->tell({robot_.pose(), pan(), clock_()}); }

  void tick() {
    robot_.tick(clock_(), std::abs(pan()) > kAway);
    tell();
    const auto head = faultAt(faults_, DeviceRole::Head, clock_());
    const auto base = faultAt(faults_, DeviceRole::Odometry, clock_());
    if (head != head_fault_) {
      damage(head_.port(), head);
      head_.setDead(head == FaultKind::Freeze);
      head_.setEcho(head == FaultKind::Echo);
      head_.setVerbose(head == FaultKind::Verbose);
      if (head == FaultKind::Limit) head_.pan().obstacle = head_.pan().position + 100.0;
      if (head_fault_ == FaultKind::Limit) head_.pan().obstacle.reset();
    }
    if (base != base_fault_) {
      damage(base_.port(), base);
      base_.setDead(base == FaultKind::Freeze);
      if (base == FaultKind::Clock) base_.jumpClock(kClockJump_s);
      if (base_fault_ == FaultKind::Clock) base_.jumpClock(-kClockJump_s);
    }
    head_fault_ = head;
    base_fault_ = base;
  }

  std::vector<Fault> faults_;
  RigClock clock_;
  StopAndGo robot_;
  std::shared_ptr<CameraPlace> place_;
  PtuEmulator head_;
  OdometryEmulator base_;
  std::optional<FaultKind> head_fault_;
  std::optional<FaultKind> base_fault_;
  QTimer timer_;
};

}  // namespace

Rig virtualStereoRig() {
  Rig rig;
  rig.name = "virtual rig with a stereo head";
  rig.range_limit_m = kRange_m;
  rig.camera = CameraRig{};
  rig.camera->kind = CameraKind::Virtual;
  rig.camera->left = "rendered";
  rig.camera->optics = cameraOf(cameraOptions());
  rig.head = HeadRig{"emulated"};
  rig.stops = sixPans();
  rig.odometry.kind = OdometryRigKind::Virtual;
  return rig;
}

MakeDevices virtualStereoDevices(VirtualDrive drive) {
  return [drive = std::move(drive)](const Rig& rig, RigMonitor& monitor) {
    const RigClock& clock = monitor.clock();
    auto robot = std::make_unique<StereoRobot>(drive, clock);
    auto open = renderedDevice({drive.world, cameraOptions(), drive.seed, 4.0, drive.faults},
                               robot->place(), clock);
    RigDevices devices;
    devices.head = std::make_unique<PtuHead>(parsePortAddress(robot->headPort(), PtuHead::kBaud),
                                             clock, PtuOptions{}, drive.seed);
    devices.odometry = std::make_unique<LineOdometry>(
        parsePortAddress(robot->basePort(), LineOdometry::kBaud), clock, drive.seed + 1);
    devices.camera = std::make_unique<VideoCamera>(
        *rig.camera, clock, [&monitor](const std::string& reason) { monitor.refused(reason); },
        [open](const std::string&, double) { return open; });
    robot.release()->setParent(devices.head.get());  // the far ends of the wires go with the head
    return devices;
  };
}

}  // namespace handmap
