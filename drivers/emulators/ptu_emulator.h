// A PTU-D46 that is not there: it speaks, moves in real time, and misbehaves on command.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <array>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/emulators/emulated_port.h"

namespace handmap {

class PtuEmulator : public QObject {
  Q_OBJECT
 public:
  struct Axis {
    double resolution_arcsec = 185.1428;
    int least = -3090;  ///< positions
    int most = 3090;
    int slowest = 57;  ///< positions a second
    int fastest = 2902;
    double speed = 1000.0;
    double acceleration = 2000.0;  ///< positions a second, each second

    double position = 0.0;
    double target = 0.0;
    double velocity = 0.0;
    std::optional<double> obstacle;  ///< it cannot pass this position
    bool obstacle_stays = false;     ///< also after a reset

    bool moving() const { return position != target; }
    /// True when it ran against the obstacle and stands there.
    bool advance(double seconds);
  };

  /// As a head is delivered: echo and verbose replies. `haste`: times real time.
  explicit PtuEmulator(EmulatedPort::Kind kind, double haste = 1.0, std::uint64_t seed = 1);

  EmulatedPort& port() { return port_; }
  Axis& pan() { return axes_[0]; }
  Axis& tilt() { return axes_[1]; }
  void setEcho(bool on) { echo_ = on; }
  void setVerbose(bool on) { verbose_ = on; }
  /// Switched off: hears and says nothing, though the cable is in.
  void setDead(bool dead) { dead_ = dead; }
  /// All commands since the last call (the newest thousand of them).
  std::vector<std::string> takeCommands();

 private:
  void hear(const QByteArray& bytes);
  void work();
  void obey(const std::string& command);
  bool obeyAxis(const std::string& command);
  bool obeySetting(const std::string& command);
  void moveTo(Axis& axis, const char* name, int position);
  void query(const std::string& words, const std::string& value);
  void say(const std::string& text);
  void halt();

  EmulatedPort port_;
  double haste_;
  std::array<Axis, 2> axes_;
  bool echo_ = true;
  bool verbose_ = true;
  bool dead_ = false;
  std::string word_;
  std::deque<std::string> waiting_;  ///< behind an await
  bool awaiting_ = false;
  bool resetting_ = false;
  std::deque<std::string> heard_;
  QTimer timer_;
  QElapsedTimer clock_;
};

}  // namespace handmap
