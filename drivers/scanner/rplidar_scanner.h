// A SLAMTEC RPLIDAR of the A or S series on a serial line (or behind TCP).
#pragma once

#include <QTimer>

#include "drivers/device/device.h"
#include "drivers/device/rig_clock.h"
#include "drivers/device/told_state.h"
#include "drivers/scanner/rplidar_protocol.h"
#include "drivers/serial/byte_port.h"

namespace handmap {

class RplidarScanner : public RangeSensor {
  Q_OBJECT
 public:
  static constexpr std::int32_t kBaud = 115200;  ///< A1, A2; A3 and S1 have 256000, S2 1000000

  RplidarScanner(PortAddress address, RigClock clock, std::uint64_t seed = 1,
                 QObject* parent = nullptr);
  ~RplidarScanner() override;

  void open() override;
  void close() override;
  int damagedAnswers() const { return reader_.damaged(); }

 private:
  enum class Step {
    Closed,
    Stopping,
    Identifying,
    Examining,
    Resetting,
    StartingExpress,
    StartingPlain,
    Scanning
  };
  void go(Step step);
  void take(const RplidarReader::Events& events);
  void takeTurn(const std::vector<RangePoint>& points);
  void watch();
  void motor(bool on);
  void tell(DeviceState state, const QString& detail);

  RigClock clock_;
  BytePort port_;
  RplidarReader reader_;
  RplidarTurns turns_;
  QTimer timer_;
  Step step_ = Step::Closed;
  double step_since_s_ = 0.0;
  int attempts_ = 0;
  double last_turn_s_ = 0.0;
  QString model_;
  ToldState told_;
};

}  // namespace handmap
