// A PTU-D46 pan-tilt head on a port.
#pragma once

#include <QTimer>
#include <optional>

#include "drivers/device/device.h"
#include "drivers/device/rig_clock.h"
#include "drivers/device/told_state.h"
#include "drivers/pan_tilt/ptu_protocol.h"
#include "drivers/serial/byte_port.h"

namespace handmap {

class PtuHead : public PanTiltHead {
  Q_OBJECT
 public:
  static constexpr std::int32_t kBaud = 9600;

  PtuHead(PortAddress address, RigClock clock, PtuOptions options = {}, std::uint64_t seed = 1,
          QObject* parent = nullptr);
  ~PtuHead() override;

  void open() override;
  void close() override;
  /// Also while it is lost: it looks there when it is back.
  void lookAt(double pan, double tilt) override;
  void halt() override;

 private:
  void begin();
  void advance();
  void tell(DeviceState state, const QString& detail);

  RigClock clock_;
  BytePort port_;
  PtuProtocol protocol_;
  QTimer timer_;
  std::optional<Look> wanted_;
  ToldState told_;
};

}  // namespace handmap
