#include "drivers/rosbridge/rosbridge_client.h"

#include <QCborArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <utility>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "drivers/rosbridge/bounded_message.h"

namespace handmap {

namespace {

const char* compressionOf(RosbridgeForm form) {
  if (form == RosbridgeForm::Json) return "none";
  return form == RosbridgeForm::Cbor ? "cbor" : "cbor-raw";
}

}  // namespace

// The fields of ROS 1 are not known here.
RosbridgeClient::RosbridgeClient(RosbridgeOptions options, std::uint64_t seed)
    : RosClient(std::move(options.url), "ws://host:9090", options.ros, seed),
      wanted_(options.form == RosbridgeForm::Raw && options.ros == RosVersion::Ros1
                  ? RosbridgeForm::Cbor
                  : options.form),
      form_(wanted_) {}

void RosbridgeClient::greet() {
  form_ = wanted_;
  fragments_ = Fragments();
  askAll();
  Q_EMIT connected();
}

void RosbridgeClient::ask(const QString& topic, const Subscription& subscription) {
  // A queue of one: the newest is worth more than all of them.
  send({{QLatin1String("op"), QLatin1String("subscribe")},
        {QLatin1String("id"), QString("handmap:" + topic)},
        {QLatin1String("topic"), topic},
        {QLatin1String("type"), subscription.type.of(version())},
        {QLatin1String("compression"), QLatin1String(compressionOf(form_))},
        {QLatin1String("queue_length"), 1}});
}

void RosbridgeClient::askNoMore(const QString& topic) {
  send({{QLatin1String("op"), QLatin1String("unsubscribe")},
        {QLatin1String("id"), QString("handmap:" + topic)},
        {QLatin1String("topic"), topic}});
}

/// One that does not know raw messages sends JSON then.
void RosbridgeClient::askForLess() {
  form_ = RosbridgeForm::Cbor;
  for (const auto& [topic, subscription] : subscriptions()) {
    askNoMore(topic);
    ask(topic, subscription);
  }
}

void RosbridgeClient::announce(const QString& topic, const Advertised& what) {
  send({{QLatin1String("op"), QLatin1String("advertise")},
        {QLatin1String("topic"), topic},
        {QLatin1String("type"), what.type.of(version())},
        {QLatin1String("latch"), what.keep == Keep::Last}});
}

void RosbridgeClient::publish(const QString& topic, const QCborMap& message) {
  send({{QLatin1String("op"), QLatin1String("publish")},
        {QLatin1String("topic"), topic},
        {QLatin1String("msg"), message}});
}

// JSON: every rosbridge reads it.
void RosbridgeClient::send(const QCborMap& message) {
  if (!isConnected()) return;
  sendText(QJsonDocument(message.toJsonObject()).toJson(QJsonDocument::Compact));
}

void RosbridgeClient::take(const QByteArray& message, bool is_text) {
  takeMessage(is_text ? parseJsonMessage(message) : parseCborMessage(message), is_text);
}

void RosbridgeClient::takeMessage(const QCborMap& message, bool is_text) {
  const RosValue value(message, "rosbridge");
  const std::string op = value.at("op").text(40);
  if (op == "fragment") {
    if (const auto whole = fragments_.add(value)) {
      const QCborMap inner = parseJsonMessage(*whole);
      if (RosValue(inner, "rosbridge").at("op").text(40) == "fragment") {
        value.fail(phrase("a fragment in fragments"), phrase("a message"));
      }
      takeMessage(inner, is_text);
    }
  } else if (op == "status") {
    const auto level = value.find("level");
    const bool bad = level && (level->text(20) == "error" || level->text(20) == "warning");
    if (bad) Q_EMIT troubled({}, QString::fromStdString(value.at("msg").text(1000)));
  } else if (op == "publish") {
    if (is_text && form_ == RosbridgeForm::Raw) askForLess();
    const QString topic = QString::fromStdString(value.at("topic").text(300));
    deliver(topic, [&] { return messageOf(message, topic); });
  }
}

RosValue RosbridgeClient::messageOf(const QCborMap& message, const QString& topic) {
  const QCborValue inner = message[QLatin1String("msg")];
  const QCborValue bytes = inner.toMap()[QLatin1String("bytes")];
  const std::string name = topic.toStdString();
  if (form_ != RosbridgeForm::Raw || !bytes.isByteArray()) return {inner, name};
  auto schema = schemas_.find(topic);
  if (schema == schemas_.end()) {
    const RosType& type = subscriptions().at(topic).type;
    schema =
        schemas_.emplace(topic, RosSchema::known(type.of(RosVersion::Ros2).toStdString())).first;
  }
  const QByteArray raw = bytes.toByteArray();
  return {schema->second.read({raw.constData(), static_cast<std::size_t>(raw.size())}, name), name};
}

}  // namespace handmap
