// A Hokuyo laser scanner that is not there.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <functional>
#include <string>

#include "drivers/emulators/emulated_port.h"
#include "drivers/scanner/scip.h"

namespace handmap {

/// Metres in a direction: radians, 0 ahead, positive to the left. Not finite: nothing there.
using RangeFunction = std::function<double(double angle_rad)>;

class HokuyoEmulator : public QObject {
  Q_OBJECT
 public:
  HokuyoEmulator(EmulatedPort::Kind kind, RangeFunction range, ScipParameters parameters = {},
                 std::uint64_t seed = 1);

  EmulatedPort& port() { return port_; }
  /// The clock of the scanner, which begins anew at 2²⁴, is set on by so much.
  void jumpClock(std::int64_t milliseconds) { clock_offset_ms_ += milliseconds; }
  /// It hears and says nothing, though the cable is in.
  void setDead(bool dead) { dead_ = dead; }
  bool isMeasuring() const { return timer_.isActive(); }
  bool isLaserOn() const { return laser_on_; }

 private:
  void hear(const QByteArray& bytes);
  void obey(const std::string& command);
  void sendParameters();
  void sendScan();

  EmulatedPort port_;
  RangeFunction range_;
  ScipParameters parameters_;
  QTimer timer_;
  QElapsedTimer clock_;
  std::int64_t clock_offset_ms_ = 0;
  bool dead_ = false;
  bool laser_on_ = false;
  std::string line_;
  std::string scan_command_;
};

}  // namespace handmap
