// A client of a Foxglove server.
#pragma once

#include <QTcpSocket>
#include <QWebSocket>
#include <QWebSocketHandshakeOptions>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/drivers/devices/waiting.h"

namespace handmap::test {

using nlohmann::json;

struct Viewer {
  explicit Viewer(quint16 port, const QString& protocol = QStringLiteral("foxglove.websocket.v1"),
                  const QString& origin = {})
      : socket(origin) {
    QObject::connect(
        &socket, &QWebSocket::textMessageReceived, &socket,
        [this](const QString& text) { texts.push_back(json::parse(text.toStdString())); });
    QObject::connect(&socket, &QWebSocket::binaryMessageReceived, &socket,
                     [this](const QByteArray& bytes) { frames.push_back(bytes); });
    QWebSocketHandshakeOptions options;
    if (!protocol.isEmpty()) options.setSubprotocols({protocol});
    socket.open(QUrl(QStringLiteral("ws://127.0.0.1:%1").arg(port)), options);
  }
  bool hears(std::size_t count) {
    return waitUntil([&] { return texts.size() >= count; });
  }
  void send(const json& message) { socket.sendTextMessage(QString::fromStdString(message.dump())); }

  QWebSocket socket;
  std::vector<json> texts;
  std::vector<QByteArray> frames;
};

/// One that takes nothing of what it is sent, once it was let in.
struct DeafViewer {
  explicit DeafViewer(quint16 port, const QByteArray& origin = {}) {
    socket.connectToHost(QHostAddress::LocalHost, port);
    socket.setReadBufferSize(kHeard);
    socket.write(
        "GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
        "Sec-WebSocket-Protocol: foxglove.websocket.v1\r\n");
    if (!origin.isEmpty()) socket.write("Origin: " + origin + "\r\n");
    socket.write("\r\n");
  }
  bool isLetIn() {
    return waitUntil([&] { return socket.bytesAvailable() >= kStatus; }) &&
           socket.peek(kStatus).endsWith(" 101");
  }
  bool isLetGo() const { return socket.state() == QAbstractSocket::UnconnectedState; }
  /// As large as a ping may be.
  void ping() { socket.write(QByteArray("\x89\xfd\0\0\0\0", 6) + QByteArray(125, 'x')); }

  static constexpr qint64 kHeard = 64;
  static constexpr qint64 kStatus = 12;  // HTTP/1.1 101
  QTcpSocket socket;
};

}  // namespace handmap::test
