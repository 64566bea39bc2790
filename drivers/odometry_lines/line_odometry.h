// The odometry of a self-made base that sends lines, see odometry_line.h.
#pragma once

#include "drivers/device/odometry_stream.h"
#include "drivers/serial/line_buffer.h"
#include "drivers/serial/port_device.h"

namespace handmap {

class LineOdometry : public PortDevice<OdometrySensor> {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(LineOdometry)
 public:
  static constexpr std::int32_t kBaud = 115200;

  LineOdometry(PortAddress address, RigClock clock, std::uint64_t seed = 1,
               QObject* parent = nullptr);
  ~LineOdometry() override;

  int refusedLines() const { return refused_; }
  int clockJumps() const { return stream_.clockJumps(); }

 private:
  void begin() override;
  void take(const QByteArray& bytes) override;
  void watch() override;
  void take(std::string_view line);

  LineBuffer lines_;
  OdometryStream stream_;
  double last_line_s_ = 0.0;
  int refused_ = 0;
};

}  // namespace handmap
