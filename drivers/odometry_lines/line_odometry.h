// The odometry of a self-made base that sends lines, see odometry_line.h.
#pragma once

#include <QTimer>

#include "drivers/device/device.h"
#include "drivers/device/odometry_stream.h"
#include "drivers/device/rig_clock.h"
#include "drivers/device/told_state.h"
#include "drivers/serial/byte_port.h"
#include "drivers/serial/line_buffer.h"

namespace handmap {

class LineOdometry : public OdometrySensor {
  Q_OBJECT
 public:
  static constexpr std::int32_t kBaud = 115200;

  LineOdometry(PortAddress address, RigClock clock, std::uint64_t seed = 1,
               QObject* parent = nullptr);
  ~LineOdometry() override;

  void open() override;
  void close() override;

  int refusedLines() const { return refused_; }
  int clockJumps() const { return stream_.clockJumps(); }

 private:
  void take(std::string_view line);
  void watch();
  void tell(DeviceState state, const QString& detail);

  RigClock clock_;
  BytePort port_;
  LineBuffer lines_;
  OdometryStream stream_;
  QTimer timer_;
  double last_line_s_ = 0.0;
  int refused_ = 0;
  ToldState told_;
};

}  // namespace handmap
