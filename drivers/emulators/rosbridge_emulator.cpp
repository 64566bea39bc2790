#include "drivers/emulators/rosbridge_emulator.h"

#include <QCborArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "drivers/rosbridge/bounded_message.h"
#include "drivers/rosbridge/ros_value.h"

namespace handmap {

namespace {

constexpr std::size_t kMostNumbers = 10'000'000;
constexpr int kUint8Tag = 64;

/// As a rosbridge writes JSON.
QJsonValue plain(const QCborValue& value) {
  if (value.isMap()) {
    QJsonObject object;
    for (const auto& [key, member] : value.toMap()) object[key.toString()] = plain(member);
    return object;
  }
  if (value.isByteArray()) return QString::fromLatin1(value.toByteArray().toBase64());
  if (value.isTag() && static_cast<quint64>(value.tag()) == kUint8Tag) {
    return plain(value.taggedValue());
  }
  if (!value.isArray() && !value.isTag()) return value.toJsonValue();
  QJsonArray array;
  if (value.isArray()) {
    for (const auto& item : value.toArray()) array.append(plain(item));
  } else {
    for (const double number : RosValue(value, "emulator").numbers(kMostNumbers)) {
      array.append(std::isfinite(number) ? QJsonValue(number) : QJsonValue());
    }
  }
  return array;
}

QByteArray jsonOf(const QCborMap& message) {
  return QJsonDocument(plain(message).toObject()).toJson(QJsonDocument::Compact);
}

}  // namespace

RosbridgeEmulator::RosbridgeEmulator()
    : server_(QStringLiteral("rosbridge emulator"), QWebSocketServer::NonSecureMode) {
  connect(&server_, &QWebSocketServer::newConnection, this, &RosbridgeEmulator::welcome);
  plug();
}

RosbridgeEmulator::~RosbridgeEmulator() { unplug(); }

QUrl RosbridgeEmulator::url() const { return QUrl(QStringLiteral("ws://127.0.0.1:%1").arg(port_)); }

void RosbridgeEmulator::plug() {
  if (server_.isListening()) return;
  if (!server_.listen(QHostAddress::LocalHost, port_)) {
    throw Error(ErrorCode::RunFailed, "no port: " + server_.errorString().toStdString());
  }
  port_ = server_.serverPort();
}

void RosbridgeEmulator::unplug() {
  server_.close();
  for (const auto& [socket, client] : std::exchange(clients_, {})) {
    socket->disconnect(this);
    socket->abort();
    socket->deleteLater();
  }
}

void RosbridgeEmulator::welcome() {
  QWebSocket* socket = server_.nextPendingConnection();
  clients_[socket] = {};
  connect(socket, &QWebSocket::textMessageReceived, this,
          [this, socket](const QString& text) { take(socket, text); });
  connect(socket, &QWebSocket::disconnected, this, [this, socket] {
    clients_.erase(socket);
    socket->deleteLater();
  });
}

void RosbridgeEmulator::take(QWebSocket* socket, const QString& text) {
  try {
    obey(socket, parseJsonMessage(text.toUtf8()));
  } catch (const Error& error) {
    sendText(*socket, jsonOf({{QLatin1String("op"), QLatin1String("status")},
                              {QLatin1String("level"), QLatin1String("error")},
                              {QLatin1String("msg"), QString::fromUtf8(error.what())}}));
  }
}

void RosbridgeEmulator::obey(QWebSocket* socket, const QCborMap& message) {
  const RosValue value(message, "rosbridge");
  const std::string op = value.at("op").text(40);
  const auto text = [&](const char* key) {
    const auto member = value.find(key);
    return member ? QString::fromStdString(member->text(300)) : QString();
  };
  const QString topic = text("topic");
  if (op == "subscribe") {
    const bool is_raw = knows_raw_ && text("compression") == QLatin1String("cbor-raw");
    clients_[socket].topics[topic] = is_raw ? RosbridgeForm::Raw
                                     : text("compression") == QLatin1String("cbor")
                                         ? RosbridgeForm::Cbor
                                         : RosbridgeForm::Json;
    if (!text("type").isEmpty()) types_[topic] = text("type");
  } else if (op == "unsubscribe") {
    clients_[socket].topics.erase(topic);
  } else if (op == "advertise") {
    types_[topic] = text("type");
    if (message[QLatin1String("latch")].toBool()) kept_.insert(topic);
  } else if (op == "publish") {
    const QCborMap inner = message[QLatin1String("msg")].toMap();
    publish(topic, inner);
    Q_EMIT published(topic, inner);
  }
}

void RosbridgeEmulator::publish(const QString& topic, const QCborMap& message) {
  const QCborMap whole = {{QLatin1String("op"), QLatin1String("publish")},
                          {QLatin1String("topic"), topic},
                          {QLatin1String("msg"), message}};
  for (const auto& [socket, client] : clients_) {
    const auto found = client.topics.find(topic);
    if (found == client.topics.end()) continue;
    if (found->second == RosbridgeForm::Raw) {
      const std::string bytes = RosSchema::known(types_.value(topic).toStdString())
                                    .write(RosValue(message, topic.toStdString()));
      QCborMap raw = whole;
      raw[QLatin1String("msg")] = QCborMap{
          {QLatin1String("bytes"), QByteArray(bytes.data(), static_cast<qsizetype>(bytes.size()))}};
      socket->sendBinaryMessage(QCborValue(raw).toCbor());
    } else if (found->second == RosbridgeForm::Cbor) {
      socket->sendBinaryMessage(QCborValue(whole).toCbor());
    } else {
      sendText(*socket, jsonOf(whole));
    }
  }
}

void RosbridgeEmulator::sendText(QWebSocket& socket, const QByteArray& text) {
  if (fragment_bytes_ <= 0 || text.size() <= fragment_bytes_) {
    socket.sendTextMessage(QString::fromUtf8(text));
    return;
  }
  const int total = static_cast<int>((text.size() + fragment_bytes_ - 1) / fragment_bytes_);
  const QString id = QString::number(++fragmented_);
  for (int i = total - 1; i >= 0; --i) {  // the order is nobody's promise
    const QByteArray piece = text.mid(qsizetype{i} * fragment_bytes_, fragment_bytes_);
    socket.sendTextMessage(
        QString::fromUtf8(jsonOf({{QLatin1String("op"), QLatin1String("fragment")},
                                  {QLatin1String("id"), id},
                                  {QLatin1String("num"), i},
                                  {QLatin1String("total"), total},
                                  {QLatin1String("data"), QString::fromUtf8(piece)}})));
  }
}

void RosbridgeEmulator::sendRaw(const QByteArray& bytes, bool binary) {
  for (const auto& [socket, client] : clients_) {
    if (binary) {
      socket->sendBinaryMessage(bytes);
    } else {
      socket->sendTextMessage(QString::fromUtf8(bytes));
    }
  }
}

RosbridgeForm RosbridgeEmulator::formOf(const QString& topic) const {
  for (const auto& [socket, client] : clients_) {
    const auto found = client.topics.find(topic);
    if (found != client.topics.end()) return found->second;
  }
  return RosbridgeForm::Json;
}

bool RosbridgeEmulator::hasSubscriber(const QString& topic) const {
  for (const auto& [socket, client] : clients_) {
    if (client.topics.contains(topic)) return true;
  }
  return false;
}

}  // namespace handmap
