// The scanner and the wheels of a virtual rig.
#pragma once

#include <QTimer>
#include <memory>

#include "core/recording/observation.h"
#include "drivers/device/device.h"
#include "drivers/virtual/fault_line.h"

namespace handmap {

/// When the robot began to drive, for both devices.
class DriveClock {
 public:
  explicit DriveClock(RigClock clock) : clock_(std::move(clock)) {}
  void start() {
    if (start_s_ < 0.0) start_s_ = clock_();
  }
  double rigTime(double drive_s) const { return start_s_ + drive_s; }
  double driveTime() const { return clock_() - start_s_; }
  const RigClock& rig() const { return clock_; }

 private:
  RigClock clock_;
  double start_s_ = -1.0;
};

class VirtualOdometry : public OdometrySensor {
  Q_OBJECT
 public:
  /// `way`: poses in the odometry frame over the time of the drive.
  VirtualOdometry(std::shared_ptr<DriveClock> clock, Trajectory way, std::vector<Fault> faults);
  void open() override;
  void close() override;

 private:
  void tick();

  std::shared_ptr<DriveClock> clock_;
  Trajectory way_;
  QTimer timer_;
  FaultLine<Pose2> line_;
};

class VirtualScanner : public RangeSensor {
  Q_OBJECT
 public:
  /// `source`: its observations are the scans, at their times of the drive.
  VirtualScanner(std::shared_ptr<DriveClock> clock, std::unique_ptr<ObservationSource> source,
                 double period_s, std::vector<Fault> faults);
  void open() override;
  void close() override;

 private:
  void tick();

  std::shared_ptr<DriveClock> clock_;
  std::unique_ptr<ObservationSource> source_;
  double period_s_;
  std::optional<Observation> next_;
  std::vector<RangePoint> last_;
  double due_s_ = 0.0;
  QTimer timer_;
  FaultLine<std::vector<RangePoint>> line_;
};

}  // namespace handmap
