// A Hokuyo laser scanner that speaks SCIP 2.0, on a serial line (USB) or TCP.
#pragma once

#include <optional>

#include "drivers/device/clock_offset.h"
#include "drivers/scanner/scip.h"
#include "drivers/serial/line_buffer.h"
#include "drivers/serial/port_device.h"

namespace handmap {

class HokuyoScanner : public PortDevice<RangeSensor> {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(HokuyoScanner)
 public:
  static constexpr std::uint16_t kTcpPort = 10940;  ///< of those with Ethernet, as they come
  static constexpr std::int32_t kBaud = 115200;     ///< USB has none, older serial ones this

  HokuyoScanner(PortAddress address, RigClock clock, std::uint64_t seed = 1,
                QObject* parent = nullptr);
  ~HokuyoScanner() override;

  int damagedAnswers() const { return reader_.damaged(); }

 private:
  enum class Step { Closed, Stopping, Asking, LightingUp, Starting, Scanning };
  void go(Step step);
  void begin() override;
  void take(const QByteArray& bytes) override;
  void watch() override;
  void rest() override;
  void forget() override { step_ = Step::Closed; }
  void take(const ScipAnswer& answer);
  void takeScan(const ScipAnswer& answer);

  LineBuffer lines_;
  ScipReader reader_;
  Step step_ = Step::Closed;
  double step_since_s_ = 0.0;
  int attempts_ = 0;
  std::optional<ScipParameters> parameters_;
  ScipClock scanner_clock_;
  ClockOffset offset_;
  double last_scan_s_ = 0.0;
};

}  // namespace handmap
