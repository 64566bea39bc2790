// A server of the Foxglove WebSocket protocol: what a run tells, for whoever looks on. Nothing
// listens before listen(), and then on the loopback unless told otherwise.
#pragma once

#include <QHostAddress>
#include <QObject>
#include <QTimer>
#include <QWebSocket>
#include <QWebSocketCorsAuthenticator>
#include <QWebSocketServer>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "drivers/foxglove/foxglove_messages.h"

namespace handmap {

struct FoxgloveOptions {
  /// Web pages that may look on beside those of this machine and Foxglove's own:
  /// "https://viewer.example". What is no web page names no origin and may.
  std::vector<std::string> origins = {};
  qint64 patience_ms = 10'000;  ///< who leaves a ping unanswered for so long is let go
};

/// Nothing waits without bound for a client: who is too slow misses some, who does not read at all
/// is let go. Where all places are taken, the first who looks at nothing makes way.
class FoxgloveServer : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(FoxgloveServer)
 public:
  static constexpr quint16 kPort = 8765;

  explicit FoxgloveServer(FoxgloveOptions options = {}, QObject* parent = nullptr);
  ~FoxgloveServer() override;

  /// Port 0: any. Throws RunFailed where the port is taken.
  void listen(quint16 port = kPort, const QHostAddress& address = QHostAddress::LocalHost);
  void close();
  quint16 port() const { return server_.serverPort(); }
  int clients() const { return static_cast<int>(clients_.size()); }

  bool isWatched(FoxgloveTopic topic) const;
  /// To whoever watches the topic; `message` is made only if there is one.
  using Make = std::function<QByteArray()>;
  void publish(FoxgloveTopic topic, const Make& message);
  /// Whoever comes later gets the last one.
  void publishAndKeep(FoxgloveTopic topic, Make message);

 Q_SIGNALS:
  void clientsChanged();
  void turnedAway(const QString& origin);

 private:
  struct Client {
    std::map<std::uint32_t, std::uint32_t> channels;  ///< subscription → channel
    qint64 came_ms = 0;
    qint64 answered_ms = 0;
  };
  void check(QWebSocketCorsAuthenticator& page);
  void welcome();
  bool makePlace();
  void watch();
  void letGo(QWebSocket& socket);
  void take(QWebSocket& socket, const QString& text);
  void obey(QWebSocket& socket, const QString& text);
  void subscribe(QWebSocket& socket, std::uint32_t subscription, std::uint32_t channel);
  void send(QWebSocket& socket, std::uint32_t subscription, const QByteArray& payload);

  FoxgloveOptions options_;
  QWebSocketServer server_;
  QTimer watch_;
  qint64 pinged_ms_ = 0;
  std::map<QWebSocket*, Client> clients_;
  std::vector<FoxgloveChannel> channels_;
  std::map<std::uint32_t, Make> kept_;  ///< channel → its last message
};

}  // namespace handmap
