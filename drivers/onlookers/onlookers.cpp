#include "drivers/onlookers/onlookers.h"

#include <QTimer>
#include <algorithm>
#include <mutex>
#include <optional>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/tape/tape.h"
#include "drivers/device/reconnect.h"
#include "drivers/foxglove/foxglove_server.h"
#include "drivers/foxglove_bridge/ros_address.h"
#include "drivers/onlookers/run_state.h"
#include "drivers/rosbridge/ros_publisher.h"

namespace handmap {

namespace {

constexpr int kMap_ms = 1000;
constexpr double kSame_m = 0.125;  // half a cell: a map is told anew where a wall has moved farther
constexpr int kFrames_ms = 50;     // navigation takes what is younger than 100 ms
constexpr int kDiagnostic_ms = 1000;  // as others tell theirs
constexpr int kMostSaid = 100;        // characters of what a stranger says
constexpr int kRest_ms = 200;         // for the last messages to leave
constexpr std::uint64_t kSeed = 15;   // of the waits before it tries again

bool isSame(const Polygon& one, const Polygon& other, double within_m) {
  return std::equal(
      one.begin(), one.end(), other.begin(), other.end(),
      [within_m](const Vec2& a, const Vec2& b) { return (a - b).norm() <= within_m; });
}

}  // namespace

class Onlookers::Telling : public QObject {
 public:
  Telling(const Rig& rig, std::shared_ptr<RigMonitor> monitor, PoseGiven given)
      : rig_(rig), monitor_(std::move(monitor)), given_(std::move(given)) {
    if (!rig_.publish.ros.empty()) monitor_->add(DeviceRole::ToRos);
    if (rig_.publish.foxglove > 0) monitor_->add(DeviceRole::ToFoxglove);
    map_due_.setSingleShot(true);
    connect(&map_due_, &QTimer::timeout, this, [this] { tellMap(kSame_m); });
    port_due_.setSingleShot(true);
    connect(&port_due_, &QTimer::timeout, this, &Telling::listen);
    frames_due_.setTimerType(Qt::PreciseTimer);
    connect(&frames_due_, &QTimer::timeout, this, [this] { tellFrames(); });
    connect(&diagnostic_due_, &QTimer::timeout, this, [this] { tellState(); });
  }

  void begin() {
    guarded(DeviceRole::ToRos, [this] { beginRos(); });
    guarded(DeviceRole::ToFoxglove, [this] { beginFoxglove(); });
    frames_due_.start(kFrames_ms);
    diagnostic_due_.start(kDiagnostic_ms);
  }

  /// What was found last is told before all is closed.
  void end() {
    if (told_) tellMap(0.0);
    for (QTimer* timer : {&map_due_, &port_due_, &frames_due_, &diagnostic_due_}) timer->stop();
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
    auto client = rosClientAt(url, version, kSeed);
    connect(client.get(), &RosClient::connected, this, [say] { say(DeviceState::Ready, {}); });
    connect(client.get(), &RosClient::lost, this,
            [say](const QString& why) { say(DeviceState::Lost, why); });
    connect(client.get(), &RosClient::troubled, this,
            [say](const QString&, const QString& why) { say(DeviceState::Degraded, why); });
    ros_.emplace(std::move(client));
    connect(&*ros_, &RosPublisher::poseGiven, this, [this](const Pose2& pose) {
      if (given_ && told_) given_(told_->report.time_s, pose);
    });
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
    tellState();
    if (state_ != Certainty::Lost) {
      tellFramesOf(time_s, told_->driven);
      tellFrames();
      if (ros_) ros_->publishPose(time_s, report.pose, poseCovariance(report));
      if (foxglove_) {
        foxglove_->publish(FoxgloveTopic::Pose, [&] { return poseInFrame(time_s, report.pose); });
      }
    }
    if (foxglove_) tellSights(time_s);
    if (!map_due_.isActive()) map_due_.start(has_map_ ? kMap_ms : 0);
  }

  /// Where the odometry lies on the map holds until something else is known.
  void tellFrames() {
    if (!told_ || stateNow(told_.get(), rig_, *monitor_) == Certainty::Lost) return;
    const double now_s = monitor_->now();
    const auto odometry = monitor_->odometry();
    tellFramesOf(monitor_->robotTime(now_s), odometry ? odometry->pose : told_->driven);
  }

  void tellFramesOf(double time_s, const Pose2& driven) {
    const std::vector<FrameLink> links = linksOf(*told_, *monitor_, &driven);
    if (ros_ && rig_.publish.tf) {
      std::vector<RosPublisher::Transform> transforms;
      for (const FrameLink& link : links) {
        transforms.push_back(
            {QString::fromStdString(link.parent), QString::fromStdString(link.child), link.pose});
      }
      ros_->publishTransforms(time_s, transforms);
    }
    if (!foxglove_) return;
    for (const FrameLink& link : links) {
      foxglove_->publish(FoxgloveTopic::Transforms, [&] {
        return frameTransform(time_s, link.parent, link.child, link.pose);
      });
    }
  }

  void tellState() {
    const Certainty state = state_ = stateNow(told_.get(), rig_, *monitor_);
    if (!ros_) return;
    using Level = RosDiagnostic::Level;
    RosDiagnostic diagnostic;
    diagnostic.level = state == Certainty::Sure    ? Level::Ok
                       : state == Certainty::Rough ? Level::Warn
                                                   : Level::Error;
    diagnostic.name = QStringLiteral("handmap: localization");
    const std::string why = whyNow(state, told_.get(), *monitor_);
    diagnostic.message =
        QStringLiteral("%1: %2").arg(QLatin1String(nameOf(state)), QString::fromStdString(why));
    diagnostic.values = {{QStringLiteral("state"), QLatin1String(nameOf(state))}};
    ros_->publishDiagnostic(monitor_->robotTime(monitor_->now()), diagnostic);
  }

  /// What was seen, and where the robot may be: made only for who looks.
  void tellSights(double time_s) {
    const std::shared_ptr<const Snapshot>& told = told_;
    foxglove_->publish(FoxgloveTopic::Particles, [&] {
      std::vector<Pose2> poses;
      for (const ParticleView& particle : told->particles) poses.push_back(particle.pose);
      return posesInFrame(time_s, poses);
    });
    const auto seen = told->seen.lock();
    if (seen && !seen->percept.points.empty()) {
      foxglove_->publish(FoxgloveTopic::Points, [&] {
        return pointCloud(time_s, told->report.pose, seen->percept.points);
      });
    }
    if (!told->image.empty()) {
      foxglove_->publish(FoxgloveTopic::Image,
                         [&] { return compressedImage(time_s, told->image); });
    }
  }

  /// Of the snapshot that was told last: the first at once, and then once a second, where a wall
  /// has moved by more than `same_m`.
  void tellMap(double same_m) {
    guarded(DeviceRole::ToRos, [this, same_m] {
      // The map shares its snapshot's life.
      const std::shared_ptr<const Map> map(told_, &*told_->map);
      std::vector<Polygon> outlines;
      for (const Building& building : map->buildings) outlines.push_back(building.footprint());
      const bool is_same =
          std::equal(outlines.begin(), outlines.end(), outlines_.begin(), outlines_.end(),
                     [same_m](const Polygon& a, const Polygon& b) { return isSame(a, b, same_m); });
      if (has_map_ && is_same) return;
      has_map_ = true;
      outlines_ = std::move(outlines);
      const double time_s = monitor_->robotTime(told_->report.time_s);
      if (ros_) ros_->publishMap(time_s, map);
      if (!foxglove_) return;
      foxglove_->publishAndKeep(FoxgloveTopic::Buildings,
                                [time_s, map] { return sceneUpdate(time_s, *map); });
      foxglove_->publishAndKeep(FoxgloveTopic::Grid,
                                [time_s, map] { return gridOf(time_s, occupancyOf(*map)); });
    });
  }

  const Rig rig_;
  const std::shared_ptr<RigMonitor> monitor_;
  const PoseGiven given_;
  std::mutex mutex_;
  std::shared_ptr<const Snapshot> newest_;  // under mutex_; not nullptr: tellPose() will come
  std::shared_ptr<const Snapshot> told_;
  Certainty state_ = Certainty::Lost;
  bool has_map_ = false;
  std::vector<Polygon> outlines_;  ///< of the map that was told
  QTimer map_due_{this};
  QTimer port_due_{this};
  QTimer frames_due_{this};
  QTimer diagnostic_due_{this};
  Reconnect reconnect_{kSeed};
  std::optional<RosPublisher> ros_;
  std::optional<FoxgloveServer> foxglove_;
};

std::unique_ptr<Onlookers> Onlookers::of(const Rig& rig, std::shared_ptr<RigMonitor> monitor,
                                         PoseGiven given) {
  if (rig.publish.ros.empty() && rig.publish.foxglove == 0) return nullptr;
  return std::unique_ptr<Onlookers>(new Onlookers(rig, std::move(monitor), std::move(given)));
}

Onlookers::Onlookers(const Rig& rig, std::shared_ptr<RigMonitor> monitor, PoseGiven given)
    : telling_(std::make_unique<Telling>(rig, std::move(monitor), std::move(given))) {
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
