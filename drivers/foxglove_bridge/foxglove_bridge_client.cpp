#include "drivers/foxglove_bridge/foxglove_bridge_client.h"

#include <QCborArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtEndian>
#include <algorithm>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "drivers/device/q_phrase.h"
#include "drivers/rosbridge/bounded_message.h"

namespace handmap {

namespace {

constexpr std::size_t kMostChannels = 10'000;
constexpr std::size_t kMostSchema = 1 << 20;
constexpr std::size_t kMostSchemas = 64 << 20;  // bytes in all
constexpr std::int64_t kLargestId = 0xffffffff;
constexpr char kMessageData = 1;    // of the server: number of the subscription, time, message
constexpr char kClientMessage = 1;  // of the client: number of the channel, message
constexpr qsizetype kServerHead = 13;
constexpr qsizetype kClientHead = 5;
constexpr std::int64_t kWarning = 1;

QUrl webSocketOf(QUrl url) {
  if (!FoxgloveBridgeClient::isAddress(url)) return {};
  url.setScheme(QLatin1String(url.scheme() == QLatin1String("foxglove") ? "ws" : "wss"));
  if (url.port() < 0) url.setPort(FoxgloveBridgeClient::kPort);
  return url;
}

QCborArray listOf(const QCborValue& value) { return QCborArray{value}; }

}  // namespace

bool FoxgloveBridgeClient::isAddress(const QUrl& url) {
  const bool has_scheme =
      url.scheme() == QLatin1String("foxglove") || url.scheme() == QLatin1String("foxgloves");
  return has_scheme && !url.host().isEmpty();
}

FoxgloveBridgeClient::FoxgloveBridgeClient(const QUrl& url, std::uint64_t seed)
    : RosClient(webSocketOf(url), "foxglove://host:8765", RosVersion::Ros2, seed) {}

QWebSocketHandshakeOptions FoxgloveBridgeClient::handshake() const {
  QWebSocketHandshakeOptions options;
  options.setSubprotocols(
      {QStringLiteral("foxglove.sdk.v1"), QStringLiteral("foxglove.websocket.v1")});
  return options;
}

void FoxgloveBridgeClient::greet() {
  is_informed_ = takes_messages_ = false;
  channels_.clear();
  asked_.clear();
  told_.clear();
}

void FoxgloveBridgeClient::take(const QByteArray& message, bool is_text) {
  if (!is_text) return takeFrame(message);
  const RosValue value(parseJsonMessage(message), "foxglove");
  const std::string op = value.at("op").text(40);
  if (op == "serverInfo") {
    takeInfo(value);
  } else if (op == "advertise") {
    takeChannels(value.at("channels"));
  } else if (op == "unadvertise") {
    forgetChannels(value.at("channelIds"));
  } else if (op == "status" && value.at("level").integer(0, 10) >= kWarning) {
    Q_EMIT troubled({}, QString::fromStdString(value.at("message").text(1000)));
  }
}

void FoxgloveBridgeClient::takeInfo(const RosValue& info) {
  const auto has = [&](const char* key, const std::string& word) {
    const auto list = info.find(key);
    if (!list) return false;
    const auto items = list->items(100);
    return std::any_of(items.begin(), items.end(),
                       [&](const RosValue& item) { return item.text(100) == word; });
  };
  takes_messages_ = has("capabilities", "clientPublish") && has("supportedEncodings", "cdr");
  is_informed_ = true;
  askAll();
  Q_EMIT connected();
  if (!advertised().empty() && !takes_messages_) {
    Q_EMIT troubled({},
                    qPhrase("this bridge takes no messages of ROS 2: ROS is not told anything"));
  }
}

void FoxgloveBridgeClient::takeChannels(const RosValue& channels) {
  std::size_t kept = 0;  // bytes
  for (const auto& [name, channel] : channels_) kept += channel.schema.size();
  for (const RosValue& each : channels.items(kMostChannels)) {
    const QString topic = QString::fromStdString(each.at("topic").text(300));
    if (channels_.size() >= kMostChannels || kept > kMostSchemas) {
      channels.fail(phrase("more than {} values", kMostChannels), phrase("fewer"));
    }
    channels_[topic] = {static_cast<std::uint32_t>(each.at("id").integer(0, kLargestId)),
                        QString::fromStdString(each.at("encoding").text(40)),
                        each.at("schemaName").text(300), each.at("schema").text(kMostSchema)};
    kept += channels_[topic].schema.size();
    const auto wanted = subscriptions().find(topic);
    if (wanted != subscriptions().end()) ask(topic, wanted->second);
  }
}

void FoxgloveBridgeClient::forgetChannels(const RosValue& ids) {
  for (const RosValue& each : ids.items(kMostChannels)) {
    const auto id = static_cast<std::uint32_t>(each.integer(0, kLargestId));
    std::erase_if(channels_, [id](const auto& channel) { return channel.second.id == id; });
    std::erase_if(asked_, [id](const auto& asked) { return asked.second.channel == id; });
  }
}

void FoxgloveBridgeClient::ask(const QString& topic, const Subscription&) {
  const auto found = channels_.find(topic);
  if (!is_informed_ || found == channels_.end()) return;  // it may come
  const Channel& channel = found->second;
  try {
    const bool is_ros1 = channel.encoding == QLatin1String("ros1");
    if (!is_ros1 && channel.encoding != QLatin1String("cdr")) {
      throwBadInput(topic.toStdString(), "", '"' + channel.encoding.toStdString() + '"',
                    "\"cdr\", \"ros1\"");
    }
    std::erase_if(asked_, [&](const auto& asked) { return asked.second.topic == topic; });
    const std::uint32_t id = ++last_id_;
    asked_.emplace(id, Asked{topic, channel.id,
                             RosSchema(channel.type, channel.schema,
                                       is_ros1 ? MessageEncoding::Ros1 : MessageEncoding::Cdr)});
    const QCborMap subscription = {{QLatin1String("id"), qint64{id}},
                                   {QLatin1String("channelId"), qint64{channel.id}}};
    send({{QLatin1String("op"), QLatin1String("subscribe")},
          {QLatin1String("subscriptions"), listOf(subscription)}});
  } catch (const Error& error) {
    Q_EMIT troubled(topic, QString::fromUtf8(error.what()));
  }
}

void FoxgloveBridgeClient::askNoMore(const QString& topic) {
  for (auto asked = asked_.begin(); asked != asked_.end(); ++asked) {
    if (asked->second.topic != topic) continue;
    send({{QLatin1String("op"), QLatin1String("unsubscribe")},
          {QLatin1String("subscriptionIds"), listOf(qint64{asked->first})}});
    asked_.erase(asked);
    return;
  }
}

void FoxgloveBridgeClient::announce(const QString& topic, const Advertised& what) {
  if (!takes_messages_) return;
  const std::string type = what.type.of(RosVersion::Ros2).toStdString();
  const auto [told, is_new] = told_.try_emplace(topic, Told{last_id_ + 1, RosSchema::known(type)});
  if (!is_new) return;
  ++last_id_;
  const QCborMap channel = {{QLatin1String("id"), qint64{told->second.id}},
                            {QLatin1String("topic"), topic},
                            {QLatin1String("encoding"), QLatin1String("cdr")},
                            {QLatin1String("schemaName"), QString::fromStdString(type)}};
  send({{QLatin1String("op"), QLatin1String("advertise")},
        {QLatin1String("channels"), listOf(channel)}});
}

void FoxgloveBridgeClient::publish(const QString& topic, const QCborMap& message) {
  const auto told = told_.find(topic);
  if (told == told_.end()) return;
  const std::string written = told->second.schema.write(RosValue(message, topic.toStdString()));
  QByteArray frame(kClientHead, '\0');
  frame[0] = kClientMessage;
  qToLittleEndian(told->second.id, frame.data() + 1);
  sendBinary(frame.append(written.data(), static_cast<qsizetype>(written.size())));
}

void FoxgloveBridgeClient::takeFrame(const QByteArray& frame) {
  if (frame.isEmpty() || frame[0] != kMessageData) return;
  if (frame.size() < kServerHead) {
    throwBadInput("foxglove", "", phrase("{} bytes", frame.size()),
                  phrase("at least {}", kServerHead));
  }
  const auto asked = asked_.find(qFromLittleEndian<std::uint32_t>(frame.constData() + 1));
  if (asked == asked_.end()) return;  // it was on its way when it was asked for no more
  const QString topic = asked->second.topic;
  deliver(topic, [&] {
    const std::string name = topic.toStdString();
    const std::string_view bytes(frame.constData() + kServerHead,
                                 static_cast<std::size_t>(frame.size() - kServerHead));
    return RosValue(asked->second.schema.read(bytes, name), name);
  });
}

void FoxgloveBridgeClient::send(const QCborMap& message) {
  sendText(QJsonDocument(message.toJsonObject()).toJson(QJsonDocument::Compact));
}

}  // namespace handmap
