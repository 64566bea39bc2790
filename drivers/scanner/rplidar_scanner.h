// A SLAMTEC RPLIDAR of the A or S series on a serial line (or behind TCP).
#pragma once

#include "drivers/scanner/rplidar_protocol.h"
#include "drivers/serial/port_device.h"

namespace handmap {

class RplidarScanner : public PortDevice<RangeSensor> {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(RplidarScanner)
 public:
  static constexpr std::int32_t kBaud = 115200;  ///< A1, A2; A3 and S1 have 256000, S2 1000000

  RplidarScanner(PortAddress address, RigClock clock, std::uint64_t seed = 1,
                 QObject* parent = nullptr);
  ~RplidarScanner() override;

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
  void begin() override;
  void take(const QByteArray& bytes) override;
  void watch() override;
  void rest() override;
  void forget() override { step_ = Step::Closed; }
  void take(const RplidarReader::Events& events);
  void takeTurn(const std::vector<RangePoint>& points);
  void motor(bool on);

  RplidarReader reader_;
  RplidarTurns turns_;
  Step step_ = Step::Closed;
  double step_since_s_ = 0.0;
  int attempts_ = 0;
  double last_turn_s_ = 0.0;
  QString model_;
};

}  // namespace handmap
