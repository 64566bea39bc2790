// A client of a Foxglove server.
#pragma once

#include <QWebSocket>
#include <QWebSocketHandshakeOptions>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/drivers/devices/waiting.h"

namespace handmap::test {

using nlohmann::json;

struct Viewer {
  explicit Viewer(quint16 port, const QString& protocol = QStringLiteral("foxglove.websocket.v1")) {
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

}  // namespace handmap::test
