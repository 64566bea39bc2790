// An RPLIDAR that is not there.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <string>

#include "drivers/emulators/emulated_port.h"
#include "drivers/emulators/hokuyo_emulator.h"
#include "drivers/scanner/rplidar_protocol.h"

namespace handmap {

class RplidarEmulator : public QObject {
  Q_OBJECT
 public:
  /// What it answers to an express scan: nothing (an old firmware), or either kind.
  enum class Express { None, Capsules, Dense };

  RplidarEmulator(EmulatedPort::Kind kind, RangeFunction range, Express express,
                  std::uint64_t seed = 1);

  EmulatedPort& port() { return port_; }
  /// 0 well, 1 warning, 2 error; a reset mends it.
  void setHealth(std::uint8_t health) { health_ = health; }
  void setDead(bool dead) { dead_ = dead; }
  bool isMeasuring() const { return timer_.isActive(); }
  int resets() const { return resets_; }

 private:
  void hear(const QByteArray& bytes);
  void obey(rplidar::Request request);
  void begin(rplidar::Answer answer);
  void measure();
  void sendNode(double clockwise_rad, bool begins);
  void sendCapsule();
  unsigned rangeAt(double clockwise_rad, double units_a_metre, unsigned most) const;

  EmulatedPort port_;
  RangeFunction range_;
  Express express_;
  QTimer timer_;
  QElapsedTimer clock_;
  rplidar::Answer sending_ = rplidar::Answer::Node;
  double angle_rad_ = 0.0;  ///< clockwise, of the next measurement
  bool first_capsule_ = true;
  double due_ = 0.0;  ///< measurements
  std::uint8_t health_ = 0;
  bool dead_ = false;
  int resets_ = 0;
  std::string heard_;
};

}  // namespace handmap
