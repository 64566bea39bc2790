// What every device on a port does the same way: it opens and closes once, says nothing twice, and
// is looked after while its port is open.
#pragma once

#include <QTimer>
#include <cstdint>
#include <utility>

#include "core/rig/rig_clock.h"
#include "drivers/device/device.h"
#include "drivers/device/told_state.h"
#include "drivers/serial/byte_port.h"

namespace handmap {

/// `Kind`: OdometrySensor, RangeSensor or PanTiltHead. Whoever derives closes in its destructor.
template <typename Kind>
class PortDevice : public Kind {
 public:
  void open() final {
    if (told_.state() != DeviceState::Closed) return;
    tell(DeviceState::Connecting, opening_);
    port_.open();
  }

  void close() final {
    if (told_.state() == DeviceState::Closed) return;
    rest();
    timer_.stop();
    port_.close();
    forget();
    tell(DeviceState::Closed, {});
  }

 protected:
  /// `opening`: what it says while its port is being opened; watch() comes every so many
  /// milliseconds. `seed`: of the waiting between attempts.
  PortDevice(PortAddress address, RigClock clock, std::uint64_t seed, int watch_ms, QString opening,
             QObject* parent)
      : Kind(parent),
        clock_(std::move(clock)),
        port_(std::move(address), seed),
        opening_(std::move(opening)) {
    QObject::connect(&port_, &BytePort::opened, this, [this, watch_ms] {
      timer_.start(watch_ms);
      begin();
    });
    QObject::connect(&port_, &BytePort::received, this,
                     [this](const QByteArray& bytes) { take(bytes); });
    QObject::connect(&port_, &BytePort::lost, this, [this](const QString& why) {
      timer_.stop();
      forget();
      tell(DeviceState::Lost, why);
    });
    QObject::connect(&timer_, &QTimer::timeout, this, [this] { watch(); });
  }

  virtual void begin() = 0;  ///< the port is open
  virtual void take(const QByteArray& bytes) = 0;
  virtual void watch() = 0;
  virtual void rest() {}  ///< the port is about to be closed: the hardware stands, the laser is off
  virtual void forget() {}  ///< the port is closed or lost

  void tell(DeviceState state, const QString& detail) {
    if (told_.changes(state, detail)) Q_EMIT this->stateChanged(state, detail);
  }
  DeviceState stateTold() const { return told_.state(); }
  double now_s() const { return clock_(); }
  BytePort& port() { return port_; }

 private:
  RigClock clock_;
  BytePort port_;
  QTimer timer_;
  QString opening_;
  ToldState told_;
};

}  // namespace handmap
