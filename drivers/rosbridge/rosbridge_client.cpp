#include "drivers/rosbridge/rosbridge_client.h"

#include <QCborArray>
#include <QDeadlineTimer>
#include <QJsonDocument>
#include <QJsonObject>
#include <utility>

#include "core/base/error.h"
#include "drivers/device/q_phrase.h"
#include "drivers/rosbridge/bounded_message.h"

namespace handmap {

namespace {

constexpr qint64 kMostWaiting = 8 << 20;  // bytes not yet sent
/// The largest message may yet be on its way; what comes on top is pongs that nobody takes.
constexpr qint64 kDeafServer = 4 * kMostWaiting;
constexpr int kConnectionWatch_ms = 100;  // a flood of pings fills some megabytes in between
constexpr qint64 kPing_ms = 1000;
constexpr qint64 kPatience_ms = 5000;

qint64 now_ms() { return QDeadlineTimer::current(Qt::PreciseTimer).deadline(); }

}  // namespace

RosbridgeClient::RosbridgeClient(RosbridgeOptions options, std::uint64_t seed)
    : options_(std::move(options)), reconnect_(seed) {
  const QUrl& url = options_.url;
  const bool web_socket =
      url.scheme() == QLatin1String("ws") || url.scheme() == QLatin1String("wss");
  if (!url.isValid() || !web_socket || url.host().isEmpty()) {
    throwBadInput("rosbridge", "", '"' + url.toString().toStdString() + '"', "ws://host:9090");
  }
  retry_.setSingleShot(true);
  connect(&retry_, &QTimer::timeout, this, &RosbridgeClient::attempt);
  connect(&watch_, &QTimer::timeout, this, &RosbridgeClient::watch);
}

RosbridgeClient::~RosbridgeClient() { letGo(); }

void RosbridgeClient::open() {
  if (++users_ == 1) retry_.start(0);
}

void RosbridgeClient::close() {
  if (users_ == 0 || --users_ > 0) return;
  retry_.stop();
  letGo();
}

bool RosbridgeClient::isConnected() const {
  return socket_ && socket_->state() == QAbstractSocket::ConnectedState;
}

void RosbridgeClient::attempt() {
  socket_ = new QWebSocket(QString(), QWebSocketProtocol::VersionLatest, this);
  socket_->setMaxAllowedIncomingMessageSize(static_cast<quint64>(MessageLimits{}.bytes));
  socket_->setMaxAllowedIncomingFrameSize(static_cast<quint64>(MessageLimits{}.bytes));
  connect(socket_, &QWebSocket::connected, this, &RosbridgeClient::greet);
  connect(socket_, &QWebSocket::disconnected, this, [this, socket = socket_] {
    giveUp(QStringLiteral("%1: %2").arg(options_.url.toString(), qReason(socket->errorString())));
  });
  connect(socket_, qOverload<QAbstractSocket::SocketError>(&QWebSocket::error), this,
          [this, socket = socket_] {
            giveUp(QStringLiteral("%1: %2").arg(options_.url.toString(),
                                                qReason(socket->errorString())));
          });
  connect(socket_, &QWebSocket::textMessageReceived, this, &RosbridgeClient::takeText);
  connect(socket_, &QWebSocket::binaryMessageReceived, this, &RosbridgeClient::takeBinary);
  connect(socket_, &QWebSocket::pong, this, [this] { heard_ms_ = now_ms(); });
  heard_ms_ = now_ms();
  watch_.start(kConnectionWatch_ms);
  socket_->open(options_.url);
}

void RosbridgeClient::greet() {
  heard_ms_ = now_ms();
  fragments_ = Fragments();
  for (const auto& [topic, subscription] : subscriptions_) sendSubscribe(topic, subscription);
  for (const auto& [topic, what] : std::map(advertised_)) advertise(topic, what.type, what.keep);
  Q_EMIT connected();
}

// A cable that was pulled is told by nobody: the server is asked whether it is still there.
void RosbridgeClient::watch() {
  if (!socket_) return watch_.stop();
  if (now_ms() - heard_ms_ > kPatience_ms) {
    return giveUp(qPhrase("nobody answers at {}", options_.url.toString().toStdString()));
  }
  if (socket_->bytesToWrite() > kDeafServer) {
    return giveUp(
        qPhrase("{} does not take what it is sent", options_.url.toString().toStdString()));
  }
  if (!isConnected() || now_ms() - pinged_ms_ < kPing_ms) return;
  pinged_ms_ = now_ms();
  socket_->ping();
}

void RosbridgeClient::giveUp(const QString& why) {
  if (!socket_) return;
  letGo();
  if (users_ > 0) retry_.start(reconnect_.nextDelay());
  Q_EMIT lost(why);
}

void RosbridgeClient::letGo() {
  watch_.stop();
  if (!socket_) return;
  QWebSocket* socket = std::exchange(socket_, nullptr);
  socket->disconnect(this);
  // One that does not take what waits would hold it until it does.
  const bool takes = socket->bytesToWrite() <= kMostWaiting;
  if (takes && socket->state() == QAbstractSocket::ConnectedState) {
    socket->close();
  } else {
    socket->abort();
  }
  socket->deleteLater();  // it may be the one that called
}

void RosbridgeClient::subscribe(const QString& topic, const RosType& type, Take take) {
  Subscription& subscription = subscriptions_[topic] = {type, std::move(take)};
  if (isConnected()) sendSubscribe(topic, subscription);
}

void RosbridgeClient::sendSubscribe(const QString& topic, const Subscription& subscription) {
  // A queue of one: the newest is worth more than all of them.
  send({{QLatin1String("op"), QLatin1String("subscribe")},
        {QLatin1String("id"), QString("handmap:" + topic)},
        {QLatin1String("topic"), topic},
        {QLatin1String("type"), subscription.type.of(options_.ros)},
        {QLatin1String("compression"), QLatin1String(options_.cbor ? "cbor" : "none")},
        {QLatin1String("queue_length"), 1}});
}

void RosbridgeClient::unsubscribe(const QString& topic) {
  if (subscriptions_.erase(topic) == 0 || !isConnected()) return;
  send({{QLatin1String("op"), QLatin1String("unsubscribe")},
        {QLatin1String("id"), QString("handmap:" + topic)},
        {QLatin1String("topic"), topic}});
}

void RosbridgeClient::advertise(const QString& topic, const RosType& type, Keep keep) {
  advertised_[topic] = {type, keep};
  if (!isConnected()) return;
  send({{QLatin1String("op"), QLatin1String("advertise")},
        {QLatin1String("topic"), topic},
        {QLatin1String("type"), type.of(options_.ros)},
        {QLatin1String("latch"), keep == Keep::Last}});
}

void RosbridgeClient::publish(const QString& topic, const QCborMap& message) {
  send({{QLatin1String("op"), QLatin1String("publish")},
        {QLatin1String("topic"), topic},
        {QLatin1String("msg"), message}});
}

// JSON: every rosbridge reads it.
void RosbridgeClient::send(const QCborMap& message) {
  if (!isConnected() || socket_->bytesToWrite() > kMostWaiting) return;
  const QJsonDocument document(message.toJsonObject());
  socket_->sendTextMessage(QString::fromUtf8(document.toJson(QJsonDocument::Compact)));
}

template <typename Read>
void RosbridgeClient::guarded(Read read) {
  heard_ms_ = now_ms();
  try {
    take(read());
  } catch (const Error& error) {
    Q_EMIT troubled({}, QString::fromUtf8(error.what()));
  }
}

void RosbridgeClient::takeText(const QString& text) {
  guarded([&] { return parseJsonMessage(text.toUtf8()); });
}

void RosbridgeClient::takeBinary(const QByteArray& bytes) {
  guarded([&] { return parseCborMessage(bytes); });
}

void RosbridgeClient::take(const QCborMap& message) {
  const RosValue value(message, "rosbridge");
  const std::string op = value.at("op").text(40);
  if (op == "fragment") {
    if (const auto whole = fragments_.add(value)) {
      const QCborMap inner = parseJsonMessage(*whole);
      if (RosValue(inner, "rosbridge").at("op").text(40) == "fragment") {
        value.fail(phrase("a fragment in fragments"), phrase("a message"));
      }
      take(inner);
    }
  } else if (op == "status") {
    const auto level = value.find("level");
    const bool bad = level && (level->text(20) == "error" || level->text(20) == "warning");
    if (bad) Q_EMIT troubled({}, QString::fromStdString(value.at("msg").text(1000)));
  } else if (op == "publish") {
    const QString topic = QString::fromStdString(value.at("topic").text(300));
    const auto found = subscriptions_.find(topic);
    if (found == subscriptions_.end()) return;
    const Take take_message = found->second.take;  // it may unsubscribe
    try {
      take_message(RosValue(message[QLatin1String("msg")], topic.toStdString()));
      reconnect_.succeeded();
    } catch (const Error& error) {
      Q_EMIT troubled(topic, QString::fromUtf8(error.what()));
    }
  }
}

}  // namespace handmap
