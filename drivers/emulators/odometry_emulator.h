// A self-made base that is not there: it sends its odometry as lines.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <functional>
#include <string_view>

#include "core/geometry/pose2.h"
#include "drivers/emulators/emulated_port.h"

namespace handmap {

class OdometryEmulator : public QObject {
  Q_OBJECT
 public:
  enum class Form { Fields, FieldsWithChecksum, Json };
  /// The pose at a time in seconds since it was switched on.
  using PoseFunction = std::function<Pose2(double time_s)>;

  OdometryEmulator(EmulatedPort::Kind kind, PoseFunction pose, Form form, int interval_ms = 20,
                   std::uint64_t seed = 1);

  EmulatedPort& port() { return port_; }
  void jumpClock(double seconds) { clock_offset_s_ += seconds; }
  void setDead(bool dead) { dead_ = dead; }
  /// Something else in between.
  void say(std::string_view text) { port_.write(text); }

 private:
  void sendLine();

  EmulatedPort port_;
  PoseFunction pose_;
  Form form_;
  QTimer timer_;
  QElapsedTimer clock_;
  double clock_offset_s_ = 1000.0;  ///< bases count from when they like
  bool dead_ = false;
};

}  // namespace handmap
