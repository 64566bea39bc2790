#include "drivers/emulators/foxglove_bridge_emulator.h"

#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtEndian>
#include <algorithm>

#include "core/bags/ros_definitions.h"
#include "core/base/error.h"
#include "drivers/rosbridge/bounded_message.h"

namespace handmap {

namespace {

QByteArray textOf(const QJsonObject& message) {
  return QJsonDocument(message).toJson(QJsonDocument::Compact);
}

}  // namespace

FoxgloveBridgeEmulator::FoxgloveBridgeEmulator()
    : server_(QStringLiteral("foxglove_bridge emulator"), QWebSocketServer::NonSecureMode) {
  server_.setSupportedSubprotocols(
      {QStringLiteral("foxglove.sdk.v1"), QStringLiteral("foxglove.websocket.v1")});
  connect(&server_, &QWebSocketServer::newConnection, this, &FoxgloveBridgeEmulator::welcome);
  plug();
}

FoxgloveBridgeEmulator::~FoxgloveBridgeEmulator() { unplug(); }

QUrl FoxgloveBridgeEmulator::url() const {
  return QUrl(QStringLiteral("foxglove://127.0.0.1:%1").arg(port_));
}

void FoxgloveBridgeEmulator::plug() {
  if (server_.isListening()) return;
  if (!server_.listen(QHostAddress::LocalHost, port_)) {
    throw Error(ErrorCode::RunFailed, "no port: " + server_.errorString().toStdString());
  }
  port_ = server_.serverPort();
}

void FoxgloveBridgeEmulator::unplug() {
  server_.close();
  for (const auto& [socket, client] : std::exchange(clients_, {})) {
    socket->disconnect(this);
    socket->abort();
    socket->deleteLater();
  }
}

void FoxgloveBridgeEmulator::welcome() {
  QWebSocket* socket = server_.nextPendingConnection();
  clients_[socket] = {};
  subprotocol_ = socket->subprotocol();
  connect(socket, &QWebSocket::textMessageReceived, this,
          [this, socket](const QString& text) { obey(clients_[socket], text.toUtf8()); });
  connect(socket, &QWebSocket::binaryMessageReceived, this,
          [this, socket](const QByteArray& frame) { hear(clients_[socket], frame); });
  connect(socket, &QWebSocket::disconnected, this, [this, socket] {
    clients_.erase(socket);
    socket->deleteLater();
  });
  socket->sendTextMessage(QStringLiteral(
      R"({"op":"serverInfo","name":"emulator","capabilities":["clientPublish","time"],)"
      R"("supportedEncodings":["json","cdr"],"metadata":{},"sessionId":"1"})"));
  for (const auto& [topic, channel] : channels_) {
    socket->sendTextMessage(QString::fromUtf8(advertisement(topic, channel)));
  }
}

QByteArray FoxgloveBridgeEmulator::advertisement(const QString& topic,
                                                 const Channel& channel) const {
  const QJsonObject described{{"id", qint64{channel.id}},
                              {"topic", topic},
                              {"encoding", encoding_},
                              {"schemaName", QString::fromStdString(channel.type)},
                              {"schemaEncoding", "ros2msg"},
                              {"schema", QString::fromStdString(rosDefinition(channel.type))}};
  return textOf({{"op", "advertise"}, {"channels", QJsonArray{described}}});
}

void FoxgloveBridgeEmulator::offer(const QString& topic, const std::string& type) {
  const auto [channel, is_new] =
      channels_.try_emplace(topic, Channel{++last_id_, type, RosSchema::known(type)});
  if (is_new) sendRaw(advertisement(topic, channel->second), false);
}

void FoxgloveBridgeEmulator::withdraw(const QString& topic) {
  const auto channel = channels_.extract(topic);
  if (channel.empty()) return;
  const std::uint32_t id = channel.mapped().id;
  for (auto& [socket, client] : clients_) {
    std::erase_if(client.asked, [id](const auto& asked) { return asked.second == id; });
  }
  sendRaw(textOf({{"op", "unadvertise"}, {"channelIds", QJsonArray{qint64{id}}}}), false);
}

void FoxgloveBridgeEmulator::obey(Client& client, const QByteArray& text) {
  const QJsonObject request = QJsonDocument::fromJson(text).object();
  const QString op = request["op"].toString();
  const auto number = [](const QJsonValue& value) {
    return static_cast<std::uint32_t>(value.toInteger());
  };
  for (const QJsonValue each : request["subscriptions"].toArray()) {
    client.asked[number(each["id"])] = number(each["channelId"]);
  }
  for (const QJsonValue each : request["subscriptionIds"].toArray()) {
    client.asked.erase(number(each));
  }
  if (op != QLatin1String("advertise")) return;
  for (const QJsonValue each : request["channels"].toArray()) {
    client.told[number(each["id"])] = {each["topic"].toString(),
                                       each["schemaName"].toString().toStdString()};
  }
}

void FoxgloveBridgeEmulator::hear(const Client& client, const QByteArray& frame) {
  if (frame.size() < 5 || frame[0] != 1) return;
  const auto told = client.told.find(qFromLittleEndian<std::uint32_t>(frame.constData() + 1));
  if (told == client.told.end()) return;
  const auto& [topic, type] = told->second;
  const std::string_view bytes(frame.constData() + 5, static_cast<std::size_t>(frame.size() - 5));
  Q_EMIT published(topic, QString::fromStdString(type),
                   RosSchema::known(type).read(bytes, topic.toStdString()));
}

void FoxgloveBridgeEmulator::publish(const QString& topic, const QCborMap& message) {
  const Channel& channel = channels_.at(topic);
  const std::string written = channel.schema.write(RosValue(message, topic.toStdString()));
  QByteArray frame(13, '\0');
  frame[0] = 1;
  qToLittleEndian<quint64>(static_cast<quint64>(QDateTime::currentMSecsSinceEpoch()) * 1'000'000,
                           frame.data() + 5);
  frame.append(written.data(), static_cast<qsizetype>(written.size()));
  for (const auto& [socket, client] : clients_) {
    for (const auto& [subscription, asked] : client.asked) {
      if (asked != channel.id) continue;
      qToLittleEndian(subscription, frame.data() + 1);
      socket->sendBinaryMessage(frame);
    }
  }
}

void FoxgloveBridgeEmulator::sendRaw(const QByteArray& bytes, bool binary) {
  for (const auto& [socket, client] : clients_) {
    if (binary) {
      socket->sendBinaryMessage(bytes);
    } else {
      socket->sendTextMessage(QString::fromUtf8(bytes));
    }
  }
}

bool FoxgloveBridgeEmulator::hasSubscriber(const QString& topic) const {
  const auto channel = channels_.find(topic);
  if (channel == channels_.end()) return false;
  return std::any_of(clients_.begin(), clients_.end(), [&](const auto& client) {
    const auto& asked = client.second.asked;
    return std::any_of(asked.begin(), asked.end(), [&](const auto& subscription) {
      return subscription.second == channel->second.id;
    });
  });
}

}  // namespace handmap
