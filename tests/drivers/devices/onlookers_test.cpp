// A run that is told to ROS and to Foxglove.
#include "drivers/onlookers/onlookers.h"

#include <QCborArray>
#include <QTcpServer>
#include <QtEndian>
#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

#include <gtest/gtest.h>

#include "core/tape/tape.h"
#include "drivers/emulators/rosbridge_emulator.h"
#include "tests/drivers/devices/foxglove_viewer.h"
#include "tests/drivers/devices/peer.h"

namespace handmap {
namespace {

using test::json;
using test::Viewer;
using test::waitUntil;

/// A port that was free a moment ago.
quint16 freePort() {
  QTcpServer server;
  server.listen(QHostAddress::LocalHost);
  return server.serverPort();
}

std::shared_ptr<Snapshot> at(double x, double width) {
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->report.pose = {x, 2.0, 0.5};
  snapshot->report.pose_sigma = {0.1, 0.2, 0.03};
  snapshot->map = Lazy<Map>([width] {
    Map map;
    map.buildings.resize(1);
    map.buildings[0].shape = Rectangle{{10.0, 5.0}, width, 4.0, 0.0};
    return map;
  });
  return snapshot;
}

struct Told {
  explicit Told(const PublishRig& publish) : port(static_cast<quint16>(publish.foxglove)) {
    Rig rig;
    rig.publish = publish;
    onlookers = Onlookers::of(rig, monitor, [this](double time_s, const Pose2& pose) {
      const std::scoped_lock lock(mutex);
      given = StampedPose{time_s, pose};
    });
  }
  /// As of now.
  void tell(std::shared_ptr<Snapshot> snapshot) const {
    snapshot->report.time_s = monitor->now();
    onlookers->tell(std::move(snapshot));
  }
  std::optional<StampedPose> givenPose() {
    const std::scoped_lock lock(mutex);
    return given;
  }
  DeviceStatus status(DeviceRole role) const {
    for (const DeviceStatus& device : monitor->status().devices) {
      if (device.role == role) return device;
    }
    return {};
  }
  bool becomes(DeviceRole role, DeviceState state) const {
    return waitUntil([&] { return status(role).state == state; });
  }

  quint16 port;
  std::mutex mutex;
  std::optional<StampedPose> given;  // under mutex
  std::shared_ptr<RigMonitor> monitor = std::make_shared<RigMonitor>();
  std::unique_ptr<Onlookers> onlookers;
};

TEST(Onlookers, NobodyIsToldUnlessAsked) { EXPECT_EQ(Told(PublishRig{}).onlookers, nullptr); }

/// What came last on a topic.
struct Listener {
  explicit Listener(RosbridgeEmulator& ros) {
    QObject::connect(&ros, &RosbridgeEmulator::published, &context,
                     [this](const QString& topic, const QCborMap& message) {
                       ++count[topic];
                       last[topic] = message;
                     });
  }
  bool hears(const char* topic) {
    return waitUntil([&] { return count[QLatin1String(topic)] > 0; });
  }
  QObject context;
  std::map<QString, int> count;
  std::map<QString, QCborMap> last;
};

double poseX(const Listener& listener) {
  const auto pose = listener.last.find(QStringLiteral("/handmap/pose"));
  if (pose == listener.last.end()) return -1.0;
  return pose
      ->second[QStringLiteral("pose")][QStringLiteral("pose")][QStringLiteral("position")]
              [QStringLiteral("x")]
      .toDouble();
}

TEST(Onlookers, RosHearsOfEachPoseAndOfTheMap) {
  RosbridgeEmulator ros;
  Listener listener(ros);
  Told told({ros.url().toString().toStdString()});
  ASSERT_TRUE(told.becomes(DeviceRole::ToRos, DeviceState::Ready))
      << told.status(DeviceRole::ToRos).detail;
  told.tell(at(1.0, 7.8));
  ASSERT_TRUE(listener.hears("/handmap/buildings"));
  ASSERT_TRUE(listener.hears("/handmap/pose"));
  EXPECT_EQ(poseX(listener), 1.0);
  EXPECT_GT(
      listener.last[QStringLiteral("/handmap/map")][QStringLiteral("info")][QStringLiteral("width")]
          .toInteger(),
      8);
  EXPECT_EQ(listener.last[QStringLiteral("/handmap/buildings")][QStringLiteral("markers")]
                .toArray()
                .size(),
            2);  // all before away, and one
  for (int i = 2; i <= 20; ++i) {
    told.tell(at(i, 7.7));  // a wall 5 cm off, and so is a row of cells
    test::pass(10);
  }
  EXPECT_TRUE(waitUntil([&] { return poseX(listener) == 20.0; }));
  test::pass(1200);  // the map is told once a second
  EXPECT_EQ(listener.count[QStringLiteral("/handmap/map")], 1) << "it has hardly changed";
  EXPECT_TRUE(ros.isKept(QStringLiteral("/handmap/map")));
  told.tell(at(21.0, 30.0));
  told.onlookers.reset();  // what was found last is told all the same
  EXPECT_TRUE(waitUntil([&] { return poseX(listener) == 21.0; }));
  EXPECT_GT(
      listener.last[QStringLiteral("/handmap/map")][QStringLiteral("info")][QStringLiteral("width")]
          .toInteger(),
      120);
}

TEST(Onlookers, WhatIsToldIsOfTheRobotsTime) {
  RosbridgeEmulator ros;
  Listener listener(ros);
  Told told({ros.url().toString().toStdString()});
  told.monitor->add(DeviceRole::Scanner);
  told.monitor->stamped(DeviceRole::Scanner, 2.0, 1'700'000'002.0);
  ASSERT_TRUE(told.becomes(DeviceRole::ToRos, DeviceState::Ready));
  auto snapshot = std::make_shared<Snapshot>(*at(1.0, 8.0));
  snapshot->report.time_s = 7.25;
  told.onlookers->tell(snapshot);
  ASSERT_TRUE(listener.hears("/handmap/map"));
  ASSERT_TRUE(listener.hears("/handmap/pose"));
  for (const char* topic : {"/handmap/pose", "/handmap/map"}) {
    const QCborMap stamp = listener.last[QLatin1String(topic)][QStringLiteral("header")]
                               .toMap()[QStringLiteral("stamp")]
                               .toMap();
    EXPECT_EQ(stamp[QStringLiteral("sec")].toInteger(), 1'700'000'007) << topic;
    EXPECT_EQ(stamp[QStringLiteral("nanosec")].toInteger(), 250'000'000) << topic;
  }
}

/// What a navigation stack makes of what it hears: where the base is on the map.
struct Navigation {
  explicit Navigation(RosbridgeEmulator& ros, std::function<double()> now) {
    QObject::connect(
        &ros, &RosbridgeEmulator::published, &context,
        [this, now = std::move(now)](const QString& topic, const QCborMap& message) {
          if (topic != QLatin1String("/tf")) return;
          for (const auto& transform : message[QStringLiteral("transforms")].toArray()) {
            take(transform.toMap(), now());
          }
        });
  }
  static double stampOf(const QCborMap& message) {
    const QCborMap stamp =
        message[QStringLiteral("header")].toMap()[QStringLiteral("stamp")].toMap();
    return stamp[QStringLiteral("sec")].toDouble() +
           1e-9 * stamp[QStringLiteral("nanosec")].toDouble();
  }
  static Pose2 poseIn(const QCborValue& position, const QCborValue& turn) {
    return {position[QStringLiteral("x")].toDouble(), position[QStringLiteral("y")].toDouble(),
            2.0 * std::atan2(turn[QStringLiteral("z")].toDouble(),
                             turn[QStringLiteral("w")].toDouble())};
  }
  void take(const QCborMap& link, double now_s) {
    const QCborValue transform = link[QStringLiteral("transform")];
    const Pose2 pose =
        poseIn(transform[QStringLiteral("translation")], transform[QStringLiteral("rotation")]);
    const QString frames = link[QStringLiteral("header")][QStringLiteral("frame_id")].toString() +
                           '>' + link[QStringLiteral("child_frame_id")].toString();
    if (frames == QLatin1String("map>odom")) {
      if (!on_map.empty()) ages_s.push_back(now_s - std::prev(on_map.end())->first);
    }
    (frames == QLatin1String("map>odom") ? on_map : others[frames])[stampOf(link)] = pose;
  }
  /// Of the frame on the map at a time, as tf2 takes it: between the two that are around.
  std::optional<Pose2> mapToOdometry(double time_s) const {
    const auto after = on_map.lower_bound(time_s);
    if (after == on_map.end()) return std::nullopt;
    if (after->first == time_s || after == on_map.begin()) return after->second;
    const auto before = std::prev(after);
    return interpolated(before->second, after->second,
                        (time_s - before->first) / (after->first - before->first));
  }
  QObject context;
  std::map<double, Pose2> on_map;
  std::map<QString, std::map<double, Pose2>> others;
  std::vector<double> ages_s;
};

TEST(Onlookers, NavigationFindsTheRobotByItsOdometry) {
  RosbridgeEmulator ros;
  Listener listener(ros);
  Told told({ros.url().toString().toStdString()});
  ASSERT_TRUE(told.becomes(DeviceRole::ToRos, DeviceState::Ready));
  const RigMonitor& monitor = *told.monitor;
  const auto now = [&] { return monitor.robotTime(monitor.now()); };
  Navigation navigation(ros, now);
  const Pose2 on_map{30.0, -12.0, 0.7};  // of the rig's odometry
  const Pose2 origin{5.0, 1.0, -0.3};    // the base began anew there
  const auto base = [](double time_s) {  // in its own odometry
    return Pose2{1.5 * time_s, 0.2 * time_s, 0.1 * time_s};
  };
  told.monitor->framed({"odom", "base_link", origin});
  for (int i = 0; i < 20; ++i) {
    auto snapshot = at(0.0, 8.0);
    const double seen_s = monitor.now();
    test::pass(80);  // it takes its time to be worked in
    snapshot->report.time_s = seen_s;
    snapshot->driven = origin * base(seen_s);
    snapshot->report.pose = on_map * snapshot->driven;
    told.onlookers->tell(snapshot);
    const double stamp_s = monitor.robotTime(seen_s);
    ASSERT_TRUE(waitUntil([&] {
      return std::abs(Navigation::stampOf(listener.last[QStringLiteral("/handmap/pose")]) -
                      stamp_s) < 1e-3;
    }));
    const auto odometry = navigation.mapToOdometry(stamp_s);
    ASSERT_TRUE(odometry);
    const Pose2 robot = *odometry * base(seen_s);
    EXPECT_LT((robot.position() - snapshot->report.pose.position()).norm(), 0.01);
    EXPECT_LT(std::abs(normalizedAngle(robot.heading - snapshot->report.pose.heading)), 0.001);
  }
  EXPECT_TRUE(navigation.others.empty()) << "the base tells its odometry itself";
  std::sort(navigation.ages_s.begin(), navigation.ages_s.end());
  ASSERT_GT(navigation.ages_s.size(), 20U);
  EXPECT_LT(navigation.ages_s[navigation.ages_s.size() * 9 / 10], 0.1);
}

TEST(Onlookers, WhereRosHasNoOdometryItIsToldToo) {
  RosbridgeEmulator ros;
  Told told({ros.url().toString().toStdString()});
  ASSERT_TRUE(told.becomes(DeviceRole::ToRos, DeviceState::Ready));
  Navigation navigation(ros, [] { return 0.0; });
  auto snapshot = at(1.0, 8.0);
  snapshot->driven = {4.0, 0.0, 0.1};
  told.tell(snapshot);
  told.monitor->moved(told.monitor->now(), {4.5, 0.1, 0.1});
  ASSERT_TRUE(waitUntil([&] {
    const auto& driven = navigation.others[QStringLiteral("odom>base_link")];
    return !driven.empty() && std::prev(driven.end())->second.x == 4.5;
  }));
  const Pose2 there = std::prev(navigation.on_map.end())->second * Pose2{4.0, 0.0, 0.1};
  EXPECT_NEAR(there.x, 1.0, 1e-9);
  EXPECT_NEAR(there.heading, 0.5, 1e-9);
}

QString stateIn(Listener& listener) {
  return listener.last[QStringLiteral("/diagnostics")][QStringLiteral("status")]
      .toArray()[0]
      .toMap()[QStringLiteral("values")]
      .toArray()[0]
      .toMap()[QStringLiteral("value")]
      .toString();
}

TEST(Onlookers, WhoIsLostIsSaidToBeAndNotToldOfAsIfHeWereNot) {
  RosbridgeEmulator ros;
  Listener listener(ros);
  Told told({ros.url().toString().toStdString()});
  ASSERT_TRUE(told.becomes(DeviceRole::ToRos, DeviceState::Ready));
  ASSERT_TRUE(waitUntil([&] { return stateIn(listener) == QLatin1String("lost"); }));
  told.tell(at(1.0, 8.0));
  ASSERT_TRUE(waitUntil([&] { return stateIn(listener) == QLatin1String("sure"); }));
  auto unsure = at(2.0, 8.0);
  unsure->report.pose_sigma = {1.5, 1.5, 0.1};
  told.tell(unsure);
  ASSERT_TRUE(waitUntil([&] { return stateIn(listener) == QLatin1String("unsure"); }));
  ASSERT_TRUE(waitUntil([&] { return poseX(listener) == 2.0; }));
  auto lost = at(3.0, 8.0);
  lost->report.pose_sigma = {10.0, 3.0, 0.1};
  told.tell(lost);
  ASSERT_TRUE(waitUntil([&] { return stateIn(listener) == QLatin1String("lost"); }));
  const int told_before = listener.count[QStringLiteral("/tf")];
  test::pass(300);
  EXPECT_EQ(poseX(listener), 2.0);
  EXPECT_EQ(listener.count[QStringLiteral("/tf")], told_before);
  told.tell(at(4.0, 8.0));  // found again
  ASSERT_TRUE(waitUntil([&] { return poseX(listener) == 4.0; }));
  // Nothing more is observed.
  EXPECT_TRUE(waitUntil([&] { return stateIn(listener) == QLatin1String("lost"); }));
}

QCborMap givenAt(double x, const QString& frame) {
  const auto map = [](std::initializer_list<std::pair<const char*, QCborValue>> members) {
    QCborMap result;
    for (const auto& [key, value] : members) result.insert(QLatin1String(key), value);
    return result;
  };
  const QCborMap pose = map({{"position", map({{"x", x}, {"y", -1.0}, {"z", 0.0}})},
                             {"orientation", map({{"x", 0}, {"y", 0}, {"z", 1}, {"w", 0}})}});
  return map({{"header", map({{"stamp", map({{"sec", 0}, {"nanosec", 0}})}, {"frame_id", frame}})},
              {"pose", map({{"pose", pose}})}});
}

TEST(Onlookers, APoseThatIsGivenInRvizIsTaken) {
  RosbridgeEmulator ros;
  Told told({ros.url().toString().toStdString()});
  ASSERT_TRUE(waitUntil([&] { return ros.hasSubscriber(QStringLiteral("/initialpose")); }));
  told.tell(at(1.0, 8.0));
  ros.publish(QStringLiteral("/initialpose"), givenAt(12.5, QStringLiteral("map")));
  ASSERT_TRUE(waitUntil([&] { return told.givenPose().has_value(); }));
  EXPECT_EQ(told.givenPose()->pose.x, 12.5);
  EXPECT_NEAR(std::abs(told.givenPose()->pose.heading), kPi, 1e-9);
  ros.publish(QStringLiteral("/initialpose"), givenAt(99.0, QStringLiteral("odom")));
  ASSERT_TRUE(told.becomes(DeviceRole::ToRos, DeviceState::Degraded));
  EXPECT_NE(told.status(DeviceRole::ToRos).detail.find("\"odom\""), std::string::npos)
      << told.status(DeviceRole::ToRos).detail;
  EXPECT_EQ(told.givenPose()->pose.x, 12.5);
}

TEST(Onlookers, FoxgloveSeesWhatTheRunSees) {
  Told told({{}, freePort()});
  ASSERT_TRUE(told.becomes(DeviceRole::ToFoxglove, DeviceState::Ready));
  Viewer viewer(told.port);
  ASSERT_TRUE(viewer.hears(2));
  json subscriptions = json::array();
  for (const json& channel : viewer.texts[1]["channels"]) {
    subscriptions.push_back({{"id", channel["id"]}, {"channelId", channel["id"]}});
  }
  viewer.send({{"op", "subscribe"}, {"subscriptions", subscriptions}});
  const auto perceived = std::make_shared<Perceived>();
  perceived->percept.points = {{1.0F, 2.0F, 0.0F, 1.0F}, {3.0F, 4.0F, 0.0F, 1.0F}};
  std::map<std::string, json> heard;
  EXPECT_TRUE(waitUntil([&] {
    auto snapshot = at(1.0, 8.0);
    snapshot->seen = PastSight(perceived);
    snapshot->particles = {{{1.0, 2.0, 0.0}, 0.5}, {{1.1, 2.0, 0.0}, 0.5}};
    snapshot->image = cv::Mat(20, 30, CV_8UC1, cv::Scalar(90));
    told.tell(snapshot);
    for (const QByteArray& frame : viewer.frames) {
      const auto channel = qFromLittleEndian<quint32>(frame.constData() + 1);
      heard[viewer.texts[1]["channels"][channel - 1]["schemaName"].get<std::string>()] =
          json::parse(frame.mid(13).toStdString());
    }
    return heard.size() == 7;
  }));
  EXPECT_EQ(heard["foxglove.PosesInFrame"]["poses"].size(), 2U);
  const auto bytesOf = [&](const char* name) {
    return QByteArray::fromBase64(
        QByteArray::fromStdString(heard[name]["data"].get<std::string>()));
  };
  EXPECT_EQ(bytesOf("foxglove.PointCloud").size(), 32);
  EXPECT_EQ(heard["foxglove.PointCloud"]["pose"]["position"]["x"], 1.0);
  EXPECT_TRUE(bytesOf("foxglove.CompressedImage").startsWith("\xff\xd8"));
  const auto inside = bytesOf("foxglove.Grid").count('\x01');
  EXPECT_EQ(inside, 8 * 4 * 16);
}

TEST(Onlookers, ARosThatGoesIsNamedAndToldAgainWhenItIsBack) {
  RosbridgeEmulator ros;
  Told told({ros.url().toString().toStdString()});
  ASSERT_TRUE(told.becomes(DeviceRole::ToRos, DeviceState::Ready));
  told.tell(at(1.0, 8.0));
  ros.unplug();
  ASSERT_TRUE(told.becomes(DeviceRole::ToRos, DeviceState::Lost));
  EXPECT_FALSE(told.status(DeviceRole::ToRos).detail.empty());
  Listener listener(ros);
  ros.plug();
  ASSERT_TRUE(told.becomes(DeviceRole::ToRos, DeviceState::Ready));
  EXPECT_TRUE(waitUntil([&] { return listener.count[QStringLiteral("/handmap/map")] > 0; }));
}

TEST(Onlookers, FoxgloveSeesPoseAndMap) {
  Told told({{}, freePort()});
  ASSERT_TRUE(told.becomes(DeviceRole::ToFoxglove, DeviceState::Ready))
      << told.status(DeviceRole::ToFoxglove).detail;
  told.tell(at(1.0, 8.0));
  Viewer viewer(told.port);
  ASSERT_TRUE(viewer.hears(2));
  EXPECT_TRUE(waitUntil(
      [&] { return told.status(DeviceRole::ToFoxglove).detail.starts_with("one looks on"); }));
  viewer.send({{"op", "subscribe"},
               {"subscriptions",
                json::array({{{"id", 7}, {"channelId", 1}}, {{"id", 8}, {"channelId", 2}}})}});
  ASSERT_TRUE(waitUntil([&] { return viewer.frames.size() == 1; }));  // the map
  told.tell(at(2.5, 8.0));
  EXPECT_TRUE(waitUntil([&] {
    return viewer.frames.size() > 1 &&
           json::parse(viewer.frames.at(1).mid(13).toStdString())["pose"]["position"]["x"] == 2.5;
  }));
}

TEST(Onlookers, FoxglovesPortIsTakenAsSoonAsItIsFree) {
  auto before = std::make_unique<Told>(PublishRig{{}, freePort()});
  ASSERT_TRUE(before->becomes(DeviceRole::ToFoxglove, DeviceState::Ready));
  const Told told({{}, before->port});  // as the next drive with another robot
  ASSERT_TRUE(told.becomes(DeviceRole::ToFoxglove, DeviceState::Lost));
  told.tell(at(1.0, 8.0));
  before.reset();
  ASSERT_TRUE(told.becomes(DeviceRole::ToFoxglove, DeviceState::Ready))
      << told.status(DeviceRole::ToFoxglove).detail;
  Viewer viewer(told.port);
  ASSERT_TRUE(viewer.hears(2));
  viewer.send({{"op", "subscribe"}, {"subscriptions", {{{"id", 8}, {"channelId", 2}}}}});
  EXPECT_TRUE(waitUntil([&] { return !viewer.frames.empty(); })) << "what was told meanwhile";
}

TEST(Onlookers, WebPagesThatMayLookOnAreThoseOfTheRig) {
  Told told({{}, freePort(), false, {"https://viewer.example"}});
  ASSERT_TRUE(told.becomes(DeviceRole::ToFoxglove, DeviceState::Ready));
  test::DeafViewer friendly(told.port, "https://viewer.example");
  EXPECT_TRUE(friendly.isLetIn());
  test::DeafViewer foreign(told.port, "https://evil.example");
  EXPECT_FALSE(foreign.isLetIn());
  ASSERT_TRUE(told.becomes(DeviceRole::ToFoxglove, DeviceState::Degraded));
  EXPECT_NE(told.status(DeviceRole::ToFoxglove).detail.find("https://evil.example"),
            std::string::npos);
}

TEST(RosbridgePeer, RoslibFindsTheBaseByTfAndGivesAPose) {
  const std::string missing = test::Peer::missing(QStringLiteral("roslib"));
  if (!missing.empty()) GTEST_SKIP() << missing;
  RosbridgeEmulator ros;
  Told told({ros.url().toString().toStdString()});
  test::Peer peer(QStringLiteral("tf_peer.mjs"), {ros.url().toString()});
  ASSERT_TRUE(peer.says("READY")) << peer.said;
  auto snapshot = at(7.5, 8.0);
  snapshot->driven = {3.0, 1.0, 0.25};
  told.monitor->moved(told.monitor->now(), snapshot->driven);
  EXPECT_TRUE(waitUntil(
      [&] {
        told.tell(snapshot);
        return told.givenPose().has_value();
      },
      test::Peer::kPatience_ms));
  EXPECT_EQ(told.givenPose()->pose.x, 21.0);
  EXPECT_TRUE(peer.says("BASE 7.50 2.00 0.50")) << peer.said;
  EXPECT_TRUE(peer.says("STATE sure")) << peer.said;
}

TEST(Onlookers, WhatCannotBeIsSaidAndEndsNothing) {
  QTcpServer other;
  ASSERT_TRUE(other.listen(QHostAddress::LocalHost));
  Told told({"http://nowhere", other.serverPort()});
  EXPECT_TRUE(told.becomes(DeviceRole::ToRos, DeviceState::Lost));
  EXPECT_TRUE(told.becomes(DeviceRole::ToFoxglove, DeviceState::Lost));
  EXPECT_NE(told.status(DeviceRole::ToFoxglove).detail.find("cannot be opened"), std::string::npos);
  told.tell(at(1.0, 8.0));
}

}  // namespace
}  // namespace handmap
