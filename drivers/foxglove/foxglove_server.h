// A server of the Foxglove WebSocket protocol: where the robot is and what the drawing became, for
// whoever looks on. Nothing listens before listen(), and then on the loopback unless told
// otherwise.
#pragma once

#include <QHostAddress>
#include <QObject>
#include <QWebSocket>
#include <QWebSocketServer>
#include <cstdint>
#include <map>
#include <memory>

#include "core/map/map.h"
#include "drivers/foxglove/foxglove_messages.h"

namespace handmap {

class FoxgloveServer : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(FoxgloveServer)
 public:
  static constexpr quint16 kPort = 8765;

  explicit FoxgloveServer(QObject* parent = nullptr);
  ~FoxgloveServer() override;

  /// Port 0: any. Throws RunFailed where the port is taken.
  void listen(quint16 port = kPort, const QHostAddress& address = QHostAddress::LocalHost);
  void close();
  quint16 port() const { return server_.serverPort(); }
  int clients() const { return static_cast<int>(clients_.size()); }

  void publishPose(const Pose2& pose);
  /// Whoever comes later gets the last one.
  void publishMap(std::shared_ptr<const Map> map);

 Q_SIGNALS:
  void clientsChanged();

 private:
  struct Client {
    std::map<std::uint32_t, std::uint32_t> channels;  ///< subscription → channel
  };
  void welcome();
  void take(QWebSocket& socket, const QString& text);
  void obey(QWebSocket& socket, const QString& text);
  void subscribe(QWebSocket& socket, std::uint32_t subscription, std::uint32_t channel);
  void send(QWebSocket& socket, std::uint32_t subscription, std::uint64_t time_ns,
            const QByteArray& payload);
  void publish(std::uint32_t channel, std::uint64_t time_ns, const QByteArray& payload);

  QWebSocketServer server_;
  std::map<QWebSocket*, Client> clients_;
  FoxgloveChannel pose_;
  FoxgloveChannel scene_;
  std::shared_ptr<const Map> map_;
};

}  // namespace handmap
