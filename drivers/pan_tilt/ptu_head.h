// A PTU-D46 pan-tilt head on a port.
#pragma once

#include <optional>

#include "drivers/pan_tilt/ptu_protocol.h"
#include "drivers/serial/port_device.h"

namespace handmap {

class PtuHead : public PortDevice<PanTiltHead> {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(PtuHead)
 public:
  static constexpr std::int32_t kBaud = 9600;

  PtuHead(PortAddress address, RigClock clock, PtuOptions options = {}, std::uint64_t seed = 1,
          QObject* parent = nullptr);
  ~PtuHead() override;

  /// Also while it is lost: it looks there when it is back.
  void lookAt(double pan, double tilt) override;
  void halt() override;

 private:
  void begin() override;
  void take(const QByteArray& bytes) override;
  void watch() override;
  void rest() override { halt(); }
  void forget() override { protocol_.stop(); }
  void advance();

  PtuProtocol protocol_;
  std::optional<Look> wanted_;
};

}  // namespace handmap
