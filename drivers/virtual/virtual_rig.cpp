#include "drivers/virtual/virtual_rig.h"

#include "drivers/virtual/virtual_devices.h"

namespace handmap {

namespace {

SimulationOptions optionsOf(const VirtualDrive& drive) {
  SimulationOptions options = laserOnTheMove(drive.step_m);
  options.speed_m_s = drive.speed_m_s;
  return options;
}

std::unique_ptr<ObservationSource> sourceOf(const VirtualDrive& drive) {
  return simulate(drive.world, optionsOf(drive), drive.seed);
}

}  // namespace

Rig virtualRig(const VirtualDrive& drive) {
  Rig rig;
  rig.name = "virtual rig";
  rig.range_limit_m = optionsOf(drive).range_limit_m;
  rig.scanner = ScannerRig{ScannerKind::Virtual, "", "", {}};
  rig.odometry.kind = OdometryRigKind::Virtual;
  return rig;
}

MakeDevices virtualDevices(VirtualDrive drive) {
  return [drive = std::move(drive)](const Rig&, RigMonitor& monitor) {
    auto source = sourceOf(drive);
    const auto shared = std::make_shared<DriveClock>(monitor.clock());
    RigDevices devices;
    devices.odometry = std::make_unique<VirtualOdometry>(
        shared, Trajectory(source->info().odometry, "virtual rig"), drive.faults);
    devices.scanner = std::make_unique<VirtualScanner>(
        shared, std::move(source), drive.step_m / drive.speed_m_s, drive.faults);
    return devices;
  };
}

}  // namespace handmap
