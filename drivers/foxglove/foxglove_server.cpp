#include "drivers/foxglove/foxglove_server.h"

#include <QDeadlineTimer>
#include <QUrl>
#include <QtEndian>
#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/phrase.h"

namespace handmap {

namespace {

using nlohmann::json;

constexpr std::size_t kMostClients = 8;
constexpr std::size_t kMostSubscriptions = 64;
constexpr quint64 kLongestRequest = 64 * 1024;
constexpr qint64 kReadAtOnce = 2 * kLongestRequest;
constexpr qint64 kMostWaiting = 4 << 20;  // bytes that a client has not yet taken
/// A map of more buildings than are drawn by hand may yet be on its way; what comes on top of it is
/// answers that nobody takes.
constexpr qint64 kDeaf = 4 * kMostWaiting;
constexpr int kLook_ms = 100;    // a flood of pings fills some megabytes in between
constexpr int kPingsAtMost = 5;  // unanswered, before a client is let go
constexpr std::int64_t kLargestId = 0xffffffff;
constexpr quint8 kMessageData = 1;

std::uint64_t now_ns() {
  using namespace std::chrono;
  return static_cast<std::uint64_t>(
      duration_cast<nanoseconds>(system_clock::now().time_since_epoch()).count());
}

qint64 now_ms() { return QDeadlineTimer::current(Qt::PreciseTimer).deadline(); }

std::uint32_t idOf(FoxgloveTopic topic) { return static_cast<std::uint32_t>(topic) + 1; }

/// Pages of this machine, and Foxglove's own. Its program for the desktop is a file, or none.
bool isFamiliar(const QString& origin) {
  const QUrl url(origin);
  const QString host = url.host();
  return origin.isEmpty() || url.scheme() == QLatin1String("file") ||
         host == QLatin1String("localhost") || QHostAddress(host).isLoopback() ||
         origin == QLatin1String("https://app.foxglove.dev") ||
         origin == QLatin1String("https://studio.foxglove.dev");
}

void sendJson(QWebSocket& socket, const json& message) {
  socket.sendTextMessage(
      QString::fromStdString(message.dump(-1, ' ', false, json::error_handler_t::replace)));
}

json described(const FoxgloveChannel& channel) {
  return {{"id", channel.id},
          {"topic", channel.topic.toStdString()},
          {"encoding", "json"},
          {"schemaName", channel.schema_name.toStdString()},
          {"schemaEncoding", "jsonschema"},
          {"schema", channel.schema.toStdString()}};
}

}  // namespace

FoxgloveServer::FoxgloveServer(FoxgloveOptions options, QObject* parent)
    : QObject(parent),
      options_(std::move(options)),
      server_(QStringLiteral("Handmap"), QWebSocketServer::NonSecureMode),
      channels_(foxgloveChannels()) {
  server_.setSupportedSubprotocols(
      {QStringLiteral("foxglove.sdk.v1"), QStringLiteral("foxglove.websocket.v1")});
  connect(&server_, &QWebSocketServer::newConnection, this, &FoxgloveServer::welcome);
  connect(&server_, &QWebSocketServer::originAuthenticationRequired, this,
          [this](QWebSocketCorsAuthenticator* page) { check(*page); });
  connect(&watch_, &QTimer::timeout, this, &FoxgloveServer::watch);
}

FoxgloveServer::~FoxgloveServer() { close(); }

void FoxgloveServer::listen(quint16 port, const QHostAddress& address) {
  if (server_.isListening()) return;
  if (server_.listen(address, port)) return;
  throw Error(
      ErrorCode::RunFailed,
      phrase("Foxglove: port {} cannot be opened: {}", port, server_.errorString().toStdString()),
      phrase("another program may have it: choose another port"));
}

void FoxgloveServer::close() {
  server_.close();
  for (const auto& [socket, client] : std::exchange(clients_, {})) {
    socket->disconnect(this);
    socket->close();
    socket->deleteLater();
  }
}

/// Any page that a browser on this machine shows could read along otherwise.
void FoxgloveServer::check(QWebSocketCorsAuthenticator& page) {
  const QString origin = page.origin();
  const auto& allowed = options_.origins;
  const bool may = isFamiliar(origin) ||
                   std::find(allowed.begin(), allowed.end(), origin.toStdString()) != allowed.end();
  page.setAllowed(may);
  if (!may) Q_EMIT turnedAway(origin);
}

void FoxgloveServer::welcome() {
  QWebSocket* socket = server_.nextPendingConnection();
  if (!socket) return;
  if (socket->subprotocol().isEmpty() || !makePlace()) {
    socket->close(QWebSocketProtocol::CloseCodePolicyViolated,
                  QStringLiteral("expected the protocol foxglove.websocket.v1 and a free place"));
    return socket->deleteLater();
  }
  socket->setMaxAllowedIncomingMessageSize(kLongestRequest);
  socket->setMaxAllowedIncomingFrameSize(kLongestRequest);
  socket->setReadBufferSize(kReadAtOnce);
  Client& client = clients_[socket];
  client.came_ms = client.answered_ms = now_ms();
  connect(socket, &QWebSocket::textMessageReceived, this,
          [this, socket](const QString& text) { take(*socket, text); });
  connect(socket, &QWebSocket::pong, this,
          [this, socket] { clients_[socket].answered_ms = now_ms(); });
  connect(socket, &QWebSocket::disconnected, this, [this, socket] { letGo(*socket); });
  watch_.start(kLook_ms);
  Q_EMIT clientsChanged();
  sendJson(*socket, {{"op", "serverInfo"},
                     {"name", "Handmap " HANDMAP_VERSION},
                     {"capabilities", json::array()},
                     {"supportedEncodings", json::array()},
                     {"metadata", json::object()},
                     {"sessionId", fmt::format("{}", now_ns())}});
  json channels = json::array();
  for (const FoxgloveChannel& channel : channels_) channels.push_back(described(channel));
  sendJson(*socket, {{"op", "advertise"}, {"channels", channels}});
}

bool FoxgloveServer::makePlace() {
  if (clients_.size() < kMostClients) return true;
  // Who looks at something comes last.
  const auto first = std::min_element(clients_.begin(), clients_.end(), [](auto& a, auto& b) {
    return std::pair(!a.second.channels.empty(), a.second.came_ms) <
           std::pair(!b.second.channels.empty(), b.second.came_ms);
  });
  if (!first->second.channels.empty()) return false;
  QWebSocket& idle = *first->first;
  letGo(idle);
  idle.close(QWebSocketProtocol::CloseCodePolicyViolated,
             QStringLiteral("another one wants to look on, and this one looks at nothing"));
  return true;
}

/// Pongs and answers are sent by nobody's leave: what waits is looked at from time to time.
void FoxgloveServer::watch() {
  const qint64 now = now_ms();
  std::vector<QWebSocket*> deaf;
  const bool is_due = now - pinged_ms_ >= options_.patience_ms / kPingsAtMost;
  if (is_due) pinged_ms_ = now;
  for (const auto& [socket, client] : clients_) {
    if (socket->bytesToWrite() > kDeaf || now - client.answered_ms > options_.patience_ms) {
      deaf.push_back(socket);
    } else if (is_due) {
      socket->ping();
    }
  }
  for (QWebSocket* socket : deaf) letGo(*socket);
  if (clients_.empty()) watch_.stop();
}

void FoxgloveServer::letGo(QWebSocket& socket) {
  socket.disconnect(this);
  clients_.erase(&socket);
  socket.deleteLater();
  Q_EMIT clientsChanged();
}

void FoxgloveServer::take(QWebSocket& socket, const QString& text) {
  try {
    obey(socket, text);
  } catch (const Error& error) {
    sendJson(socket, {{"op", "status"}, {"level", 2}, {"message", error.what()}});
  }
}

void FoxgloveServer::obey(QWebSocket& socket, const QString& text) {
  const json request = parseJson(text.toStdString(), "request");
  const JsonValue value(request, "request");
  const std::string op = value.at("op").text(40);
  const auto id = [](const JsonValue& number) {
    return static_cast<std::uint32_t>(number.integer(0, kLargestId));
  };
  if (op == "subscribe") {
    for (const JsonValue& each : value.at("subscriptions").items(kMostSubscriptions)) {
      subscribe(socket, id(each.at("id")), id(each.at("channelId")));
    }
  } else if (op == "unsubscribe") {
    for (const JsonValue& each : value.at("subscriptionIds").items(kMostSubscriptions)) {
      clients_[&socket].channels.erase(id(each));
    }
  } else {
    value.at("op").fail(phrase("subscribe or unsubscribe"));
  }
}

void FoxgloveServer::subscribe(QWebSocket& socket, std::uint32_t subscription,
                               std::uint32_t channel) {
  if (channel == 0 || channel > channels_.size()) {
    throwBadInput("request", "channelId", fmt::format("{}", channel),
                  phrase("one that was advertised"));
  }
  auto& channels = clients_[&socket].channels;
  if (channels.size() >= kMostSubscriptions) {
    throwBadInput("request", "", phrase("too many subscriptions"),
                  phrase("at most {}", kMostSubscriptions));
  }
  channels[subscription] = channel;
  const auto kept = kept_.find(channel);
  if (kept != kept_.end()) send(socket, subscription, kept->second());
}

// 1, the subscription, nanoseconds since 1970 when it is sent, little-endian; then the message.
void FoxgloveServer::send(QWebSocket& socket, std::uint32_t subscription,
                          const QByteArray& payload) {
  if (socket.bytesToWrite() > kMostWaiting) return;  // it is too slow: it misses some
  QByteArray frame(13, '\0');
  frame[0] = static_cast<char>(kMessageData);
  qToLittleEndian(subscription, frame.data() + 1);
  qToLittleEndian(now_ns(), frame.data() + 5);
  socket.sendBinaryMessage(frame + payload);
}

bool FoxgloveServer::isWatched(FoxgloveTopic topic) const {
  return std::any_of(clients_.begin(), clients_.end(), [topic](const auto& client) {
    const auto& watched = client.second.channels;
    return std::any_of(watched.begin(), watched.end(), [topic](const auto& subscription) {
      return subscription.second == idOf(topic);
    });
  });
}

void FoxgloveServer::publish(FoxgloveTopic topic, const Make& message) {
  if (!isWatched(topic)) return;
  const QByteArray payload = message();
  for (const auto& [socket, client] : clients_) {
    for (const auto& [subscription, subscribed] : client.channels) {
      if (subscribed == idOf(topic)) send(*socket, subscription, payload);
    }
  }
}

void FoxgloveServer::publishAndKeep(FoxgloveTopic topic, Make message) {
  publish(topic, message);
  kept_[idOf(topic)] = std::move(message);
}

}  // namespace handmap
