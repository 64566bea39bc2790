// The far end of a serial line or a TCP port, for devices that are not there.
#pragma once

#include <QByteArray>
#include <QObject>
#include <QSocketNotifier>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/random.h"

namespace handmap {

/// What happens to each byte, in both directions.
struct WireFaults {
  double dropped = 0.0;  ///< probability
  double doubled = 0.0;  ///< probability
  int delay_ms = 0;      ///< of what the device sends
};

class EmulatedPort : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(EmulatedPort)
 public:
  enum class Kind { PseudoTerminal, Tcp };

  /// Plugged in. `seed`: of the faults. Throws RunFailed where the system gives none.
  explicit EmulatedPort(Kind kind, std::uint64_t seed = 1, QObject* parent = nullptr);
  ~EmulatedPort() override;

  /// For parsePortAddress(); the same after every plug(). TCP: on the loopback.
  std::string address() const;
  void plug();
  void unplug();
  bool isPlugged() const { return terminal_ >= 0 || server_.isListening(); }
  void setFaults(const WireFaults& faults) { faults_ = faults; }

  void write(std::string_view bytes);

 Q_SIGNALS:
  void received(const QByteArray& bytes);
  void unplugged();

 private:
  void plugTerminal();
  void plugTcp();
  void readTerminal();
  void take(const QByteArray& bytes);
  void send(std::string_view bytes);
  void sendNextLate();
  QByteArray faulty(std::string_view bytes);

  Kind kind_;
  RandomStream random_;
  WireFaults faults_;
  QTemporaryDir folder_;
  int terminal_ = -1;
  int own_end_ = -1;  ///< of the other side: without it a terminal that nobody opened is hung up
  std::unique_ptr<QSocketNotifier> notifier_;
  QTcpServer server_;
  quint16 tcp_port_ = 0;
  QTcpSocket* peer_ = nullptr;
  std::deque<QByteArray> late_;
};

}  // namespace handmap
