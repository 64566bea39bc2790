#include "drivers/rosbridge/ros_topic.h"

#include <utility>

#include "drivers/device/q_phrase.h"

namespace handmap {

namespace {

constexpr int kTopicWatch_ms = 100;
constexpr double kUnheard_s = 2.0;  // since it was connected: no rosbridge says that nobody sends

}  // namespace

RosTopic::RosTopic(std::shared_ptr<RosClient> client, QString topic, RosType type, RigClock clock,
                   Take take)
    : client_(std::move(client)),
      topic_(std::move(topic)),
      type_(std::move(type)),
      clock_(std::move(clock)),
      take_(std::move(take)) {
  connect(client_.get(), &RosClient::connected, this, [this] {
    if (!open_) return;
    awaitFirst();
    tell(DeviceState::Connecting, qPhrase("waiting for {}", topic_.toStdString()));
  });
  connect(client_.get(), &RosClient::lost, this, [this](const QString& why) {
    heard_ = false;
    if (open_) tell(DeviceState::Lost, why);
  });
  connect(client_.get(), &RosClient::troubled, this,
          [this](const QString& about, const QString& why) {
            if (!open_ || (!about.isEmpty() && about != topic_)) return;
            health_.bad();
            const bool silent = told_.state() == DeviceState::Connecting;
            if (silent || health_.degraded()) tell(DeviceState::Degraded, why);
          });
  connect(&timer_, &QTimer::timeout, this, &RosTopic::watch);
}

RosTopic::~RosTopic() {
  if (open_) RosTopic::close();
}

void RosTopic::open() {
  if (std::exchange(open_, true)) return;
  awaitFirst();
  tell(DeviceState::Connecting, qPhrase("connecting to ROS"));
  client_->subscribe(topic_, type_, [this](const RosValue& message) { come(message); });
  client_->open();
  timer_.start(kTopicWatch_ms);
}

void RosTopic::close() {
  if (!std::exchange(open_, false)) return;
  timer_.stop();
  client_->unsubscribe(topic_);
  client_->close();
  tell(DeviceState::Closed, {});
}

void RosTopic::come(const RosValue& message) {
  const double now_s = clock_();
  const QString remark = take_(message, now_s);
  last_s_ = now_s;
  heard_ = true;
  health_.good();
  const bool degraded = health_.degraded();
  if (!remark.isEmpty()) return tell(DeviceState::Degraded, remark);
  if (!degraded) tell(DeviceState::Ready, {});
}

void RosTopic::awaitFirst() {
  heard_ = false;
  last_s_ = clock_();
}

void RosTopic::watch() {
  if (!client_->isConnected()) return;
  const double silent_s = clock_() - last_s_;
  const std::string topic = topic_.toStdString();
  if (heard_ && silent_s > kSilence_s) {
    tell(DeviceState::Degraded, qPhrase("nothing comes of {} any more", topic));
  } else if (told_.state() == DeviceState::Connecting && silent_s > kUnheard_s) {
    tell(DeviceState::Connecting,
         qPhrase("nothing has come of {} yet: is that its name, and is it sent?", topic));
  }
}

void RosTopic::tell(DeviceState state, const QString& detail) {
  if (told_.changes(state, detail)) Q_EMIT stateChanged(state, detail);
}

}  // namespace handmap
