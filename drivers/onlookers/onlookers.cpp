#include "drivers/onlookers/onlookers.h"

#include <QTimer>
#include <mutex>
#include <optional>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "drivers/device/reconnect.h"
#include "drivers/foxglove/foxglove_server.h"
#include "drivers/rosbridge/ros_publisher.h"

namespace handmap {

namespace {

constexpr int kMap_ms = 1000;
constexpr int kMostSaid = 100;       // characters of what a stranger says
constexpr int kRest_ms = 200;        // for the last messages to leave
constexpr std::uint64_t kSeed = 15;  // of the waits before it tries again

}  // namespace

class Onlookers::Telling : public QObject {
 public:
  Telling(const Rig& rig, std::shared_ptr<RigMonitor> monitor)
      : rig_(rig), monitor_(std::move(monitor)) {
    if (!rig_.publish.ros.empty()) monitor_->add(DeviceRole::ToRos);
    if (rig_.publish.foxglove > 0) monitor_->add(DeviceRole::ToFoxglove);
    map_due_.setSingleShot(true);
    connect(&map_due_, &QTimer::timeout, this, &Telling::tellMap);
    port_due_.setSingleShot(true);
    connect(&port_due_, &QTimer::timeout, this, &Telling::listen);
  }

  void begin() {
    guarded(DeviceRole::ToRos, [this] { beginRos(); });
    guarded(DeviceRole::ToFoxglove, [this] { beginFoxglove(); });
  }

  /// What was found last is told before all is closed.
  void end() {
    if (map_due_.isActive()) tellMap();
    map_due_.stop();
    port_due_.stop();
    QTimer::singleShot(kRest_ms, this, [this] {
      ros_.reset();
      foxglove_.reset();
      thread()->quit();
    });
  }

  void put(std::shared_ptr<const Snapshot> snapshot) {
    const std::scoped_lock lock(mutex_);
    const bool is_asked = std::exchange(newest_, std::move(snapshot)) != nullptr;
    if (!is_asked)
      QMetaObject::invokeMethod(
          this, [this] { tellPose(); }, Qt::QueuedConnection);
  }

 private:
  template <typename Work>
  void guarded(DeviceRole role, Work work) {
    try {
      work();
    } catch (const std::exception& error) {
      monitor_->setState(role, DeviceState::Lost, error.what());
    }
  }

  void beginRos() {
    const std::string& url = rig_.publish.ros;
    if (url.empty()) return;
    const auto say = [this](DeviceState state, const QString& detail) {
      monitor_->setState(DeviceRole::ToRos, state, detail.toStdString());
    };
    say(DeviceState::Connecting, {});
    const RosVersion version = rig_.ros_version == 1 ? RosVersion::Ros1 : RosVersion::Ros2;
    auto client = std::make_shared<RosbridgeClient>(
        RosbridgeOptions{QUrl(QString::fromStdString(url)), version}, kSeed);
    connect(client.get(), &RosbridgeClient::connected, this,
            [say] { say(DeviceState::Ready, {}); });
    connect(client.get(), &RosbridgeClient::lost, this,
            [say](const QString& why) { say(DeviceState::Lost, why); });
    connect(client.get(), &RosbridgeClient::troubled, this,
            [say](const QString&, const QString& why) { say(DeviceState::Degraded, why); });
    ros_.emplace(std::move(client));
  }

  void beginFoxglove() {
    if (rig_.publish.foxglove == 0) return;
    foxglove_.emplace(FoxgloveOptions{rig_.publish.origins});
    connect(&*foxglove_, &FoxgloveServer::clientsChanged, this, [this] { sayWhoLooksOn(); });
    connect(&*foxglove_, &FoxgloveServer::turnedAway, this, [this](const QString& origin) {
      monitor_->setState(
          DeviceRole::ToFoxglove, DeviceState::Degraded,
          phrase(
              "a web page of {} was turned away: \"origins\" in the rig file would let it look on",
              origin.left(kMostSaid).toStdString()));
    });
    listen();
  }

  /// The drive before, or another program, may have the port yet.
  void listen() {
    guarded(DeviceRole::ToFoxglove, [this] {
      port_due_.start(reconnect_.nextDelay());
      foxglove_->listen(
          static_cast<quint16>(rig_.publish.foxglove),
          rig_.publish.beyond_this_machine ? QHostAddress::Any : QHostAddress::LocalHost);
      port_due_.stop();
      sayWhoLooksOn();
    });
  }

  void sayWhoLooksOn() {
    const int clients = foxglove_->clients();
    const std::string who = clients == 0   ? phrase("nobody looks")
                            : clients == 1 ? phrase("one looks")
                                           : phrase("{} look", clients);
    monitor_->setState(DeviceRole::ToFoxglove, DeviceState::Ready,
                       phrase("{} on at port {}", who, foxglove_->port()));
  }

  void tellPose() {
    {
      const std::scoped_lock lock(mutex_);
      told_ = std::exchange(newest_, nullptr);
    }
    if (!told_) return;
    const FrameReport& report = told_->report;
    const double time_s = monitor_->robotTime(report.time_s);
    if (ros_) ros_->publishPose(time_s, report.pose, report.pose_sigma);
    if (foxglove_) foxglove_->publishPose(time_s, report.pose);
    if (!map_due_.isActive()) map_due_.start(has_map_ ? kMap_ms : 0);
  }

  /// Of the snapshot that was told last: the first at once, and then once a second.
  void tellMap() {
    guarded(DeviceRole::ToRos, [this] {
      // The map shares its snapshot's life.
      const std::shared_ptr<const Map> map(told_, &*told_->map);
      has_map_ = true;
      const double time_s = monitor_->robotTime(told_->report.time_s);
      if (ros_) ros_->publishMap(time_s, map);
      if (foxglove_) foxglove_->publishMap(time_s, map);
    });
  }

  const Rig rig_;
  const std::shared_ptr<RigMonitor> monitor_;
  std::mutex mutex_;
  std::shared_ptr<const Snapshot> newest_;  // under mutex_; not nullptr: tellPose() will come
  std::shared_ptr<const Snapshot> told_;
  bool has_map_ = false;
  QTimer map_due_{this};
  QTimer port_due_{this};
  Reconnect reconnect_{kSeed};
  std::optional<RosPublisher> ros_;
  std::optional<FoxgloveServer> foxglove_;
};

std::unique_ptr<Onlookers> Onlookers::of(const Rig& rig, std::shared_ptr<RigMonitor> monitor) {
  if (rig.publish.ros.empty() && rig.publish.foxglove == 0) return nullptr;
  return std::unique_ptr<Onlookers>(new Onlookers(rig, std::move(monitor)));
}

Onlookers::Onlookers(const Rig& rig, std::shared_ptr<RigMonitor> monitor)
    : telling_(std::make_unique<Telling>(rig, std::move(monitor))) {
  telling_->moveToThread(&thread_);
  thread_.start();
  QMetaObject::invokeMethod(
      telling_.get(), [telling = telling_.get()] { telling->begin(); }, Qt::QueuedConnection);
}

Onlookers::~Onlookers() {
  QMetaObject::invokeMethod(
      telling_.get(), [telling = telling_.get()] { telling->end(); }, Qt::QueuedConnection);
  thread_.wait();
}

void Onlookers::tell(std::shared_ptr<const Snapshot> snapshot) {
  telling_->put(std::move(snapshot));
}

}  // namespace handmap
