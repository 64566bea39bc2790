// A live robot as a source of observations. It has no end but that a person ends the drive.
#pragma once

#include <memory>
#include <stop_token>

#include "core/recording/observation.h"
#include "core/rig/rig_monitor.h"
#include "drivers/live/rig_devices.h"

namespace handmap {

struct LiveJob {
  Rig rig;
  MakeDevices make;
  /// What is going on is told here, and the end of the drive is asked for here.
  std::shared_ptr<RigMonitor> monitor;
  std::filesystem::path record;  ///< a new folder; empty: not recorded
};

/// Opens the devices and waits for the first whole observation; the robot is where the drawing says
/// that it starts. The odometry is that of the rig: measured, of the images or of the scans.
/// `info().observations` is 0: without an end. Views are rectified and checked, a bad one is
/// skipped with a FrameError. nullptr when `stop` was requested, or the end of the drive, before
/// the first observation. Throws Error for a rig that cannot be: a calibration that cannot be read,
/// an address that is none, a folder that is not new.
std::unique_ptr<ObservationSource> openLive(const LiveJob& job, const std::stop_token& stop);

}  // namespace handmap
