#include "drivers/rosbridge/ros_client.h"

#include <QDeadlineTimer>
#include <utility>

#include "core/base/error.h"
#include "drivers/device/q_phrase.h"
#include "drivers/rosbridge/bounded_message.h"

namespace handmap {

namespace {

constexpr qint64 kMostUnsent = 8 << 20;  // bytes not yet sent
/// The largest message may yet be on its way; what comes on top is pongs that nobody takes.
constexpr qint64 kDeafServer = 4 * kMostUnsent;
constexpr int kConnectionWatch_ms = 100;  // a flood of pings fills some megabytes in between
constexpr qint64 kPing_ms = 1000;
constexpr qint64 kPatience_ms = 5000;

qint64 now_ms() { return QDeadlineTimer::current(Qt::PreciseTimer).deadline(); }

}  // namespace

RosClient::RosClient(QUrl url, const std::string& expected, RosVersion version, std::uint64_t seed)
    : url_(std::move(url)), version_(version), reconnect_(seed) {
  const bool web_socket =
      url_.scheme() == QLatin1String("ws") || url_.scheme() == QLatin1String("wss");
  if (!url_.isValid() || !web_socket || url_.host().isEmpty()) {
    throwBadInput("ROS", "", '"' + url_.toString().toStdString() + '"', expected);
  }
  retry_.setSingleShot(true);
  connect(&retry_, &QTimer::timeout, this, &RosClient::attempt);
  connect(&watch_, &QTimer::timeout, this, &RosClient::watch);
}

RosClient::~RosClient() { letGo(); }

void RosClient::open() {
  if (++users_ == 1) retry_.start(0);
}

void RosClient::close() {
  if (users_ == 0 || --users_ > 0) return;
  retry_.stop();
  letGo();
}

bool RosClient::isConnected() const {
  return socket_ && socket_->state() == QAbstractSocket::ConnectedState;
}

void RosClient::attempt() {
  socket_ = new QWebSocket(QString(), QWebSocketProtocol::VersionLatest, this);
  socket_->setMaxAllowedIncomingMessageSize(static_cast<quint64>(MessageLimits{}.bytes));
  socket_->setMaxAllowedIncomingFrameSize(static_cast<quint64>(MessageLimits{}.bytes));
  connect(socket_, &QWebSocket::connected, this, [this] {
    heard_ms_ = now_ms();
    greet();
  });
  const auto give_up = [this, socket = socket_] {
    giveUp(QStringLiteral("%1: %2").arg(url_.toString(), qReason(socket->errorString())));
  };
  connect(socket_, &QWebSocket::disconnected, this, give_up);
  connect(socket_, qOverload<QAbstractSocket::SocketError>(&QWebSocket::error), this, give_up);
  connect(socket_, &QWebSocket::textMessageReceived, this,
          [this](const QString& text) { takeGuarded(text.toUtf8(), true); });
  connect(socket_, &QWebSocket::binaryMessageReceived, this,
          [this](const QByteArray& bytes) { takeGuarded(bytes, false); });
  connect(socket_, &QWebSocket::pong, this, [this] { heard_ms_ = now_ms(); });
  heard_ms_ = now_ms();
  watch_.start(kConnectionWatch_ms);
  socket_->open(url_, handshake());
}

void RosClient::askAll() {
  for (const auto& [topic, subscription] : subscriptions_) ask(topic, subscription);
  for (const auto& [topic, what] : advertised_) announce(topic, what);
}

// A cable that was pulled is told by nobody: the server is asked whether it is still there.
void RosClient::watch() {
  if (!socket_) return watch_.stop();
  if (now_ms() - heard_ms_ > kPatience_ms) {
    return giveUp(qPhrase("nobody answers at {}", url_.toString().toStdString()));
  }
  if (socket_->bytesToWrite() > kDeafServer) {
    return giveUp(qPhrase("{} does not take what it is sent", url_.toString().toStdString()));
  }
  if (!isConnected() || now_ms() - pinged_ms_ < kPing_ms) return;
  pinged_ms_ = now_ms();
  socket_->ping();
}

void RosClient::giveUp(const QString& why) {
  if (!socket_) return;
  letGo();
  if (users_ > 0) retry_.start(reconnect_.nextDelay());
  Q_EMIT lost(why);
}

void RosClient::letGo() {
  watch_.stop();
  if (!socket_) return;
  QWebSocket* socket = std::exchange(socket_, nullptr);
  socket->disconnect(this);
  // One that does not take what waits would hold it until it does, one that failed takes nothing.
  const bool failed = socket->error() != QAbstractSocket::UnknownSocketError;
  const bool takes = !failed && socket->bytesToWrite() <= kMostUnsent;
  if (takes && socket->state() == QAbstractSocket::ConnectedState) {
    socket->close();
  } else {
    socket->abort();
  }
  socket->deleteLater();  // it may be the one that called
}

void RosClient::subscribe(const QString& topic, const RosType& type, Take take) {
  const Subscription& subscription = subscriptions_[topic] = {type, std::move(take)};
  if (isConnected()) ask(topic, subscription);
}

void RosClient::unsubscribe(const QString& topic) {
  if (subscriptions_.erase(topic) > 0 && isConnected()) askNoMore(topic);
}

void RosClient::advertise(const QString& topic, const RosType& type, Keep keep) {
  const Advertised& what = advertised_[topic] = {type, keep};
  if (isConnected()) announce(topic, what);
}

bool RosClient::takesMore() const {
  return isConnected() && socket_->bytesToWrite() <= kMostUnsent;
}

void RosClient::sendText(const QByteArray& text) {
  if (takesMore()) socket_->sendTextMessage(QString::fromUtf8(text));
}

void RosClient::sendBinary(const QByteArray& bytes) {
  if (takesMore()) socket_->sendBinaryMessage(bytes);
}

void RosClient::takeGuarded(const QByteArray& message, bool is_text) {
  heard_ms_ = now_ms();
  try {
    take(message, is_text);
  } catch (const Error& error) {
    Q_EMIT troubled({}, QString::fromUtf8(error.what()));
  }
}

void RosClient::deliver(const QString& topic, const std::function<RosValue()>& read) {
  const auto found = subscriptions_.find(topic);
  if (found == subscriptions_.end()) return;
  const Take take_message = found->second.take;  // it may unsubscribe
  try {
    take_message(read());
    reconnect_.succeeded();
  } catch (const Error& error) {
    Q_EMIT troubled(topic, QString::fromUtf8(error.what()));
  }
}

}  // namespace handmap
