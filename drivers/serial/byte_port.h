// Bytes to and from a device on a serial line or behind a TCP port, connected again when it is
// lost.
#pragma once

#include <QByteArray>
#include <QIODevice>
#include <QObject>
#include <QString>
#include <QTimer>
#include <cstdint>
#include <memory>
#include <string_view>

#include "drivers/device/reconnect.h"
#include "drivers/serial/port_address.h"

namespace handmap {

class BytePort : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(BytePort)
 public:
  /// `seed`: of the waiting between attempts.
  BytePort(PortAddress address, std::uint64_t seed, QObject* parent = nullptr);
  ~BytePort() override;

  /// Returns at once; tries until close().
  void open();
  /// What was written is sent first, as far as the line takes it at once.
  void close();
  bool isOpen() const;

  /// Dropped while the port is not open. A line that does not take 64 KiB is given up.
  void write(std::string_view bytes);
  /// Who is at the other end delivers what it should: the next loss is mended soon.
  void delivers() { reconnect_.succeeded(); }
  /// Who is at the other end does not: the port is closed, and tried again after a while.
  void giveUp(const QString& why);
  /// As RPLIDAR A1 wants it for its motor. Without effect where there is no such line.
  void setDataTerminalReady(bool ready);

  const PortAddress& address() const { return address_; }

 Q_SIGNALS:
  void opened();
  void received(const QByteArray& bytes);
  /// After opened(), or instead of it.
  void lost(const QString& why);

 private:
  void attempt();
  void openSerial(const SerialAddress& address);
  void openTcp(const TcpAddress& address);
  void becomeOpen();
  void read();
  void letGo();

  PortAddress address_;
  Reconnect reconnect_;
  QTimer retry_;
  QTimer patience_;  ///< of a connection that is being made
  QIODevice* device_ = nullptr;
};

}  // namespace handmap
