// A run that is told to ROS and to Foxglove.
#include "drivers/onlookers/onlookers.h"

#include <QCborArray>
#include <QTcpServer>
#include <memory>

#include <gtest/gtest.h>

#include "drivers/emulators/rosbridge_emulator.h"
#include "tests/drivers/devices/foxglove_viewer.h"

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

std::shared_ptr<const Snapshot> at(double x, double width) {
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
    onlookers = Onlookers::of(rig, monitor);
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
  told.onlookers->tell(at(1.0, 8.0));
  ASSERT_TRUE(waitUntil([&] { return listener.count.size() == 3; }));
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
    told.onlookers->tell(at(i, 8.0));
    test::pass(10);
  }
  EXPECT_TRUE(waitUntil([&] { return poseX(listener) == 20.0; }));
  EXPECT_LE(listener.count[QStringLiteral("/handmap/map")], 2);  // in a fifth of a second
  told.onlookers->tell(at(21.0, 30.0));
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
  ASSERT_TRUE(waitUntil([&] { return listener.count.size() == 3; }));
  for (const char* topic : {"/handmap/pose", "/handmap/map"}) {
    const QCborMap stamp = listener.last[QLatin1String(topic)][QStringLiteral("header")]
                               .toMap()[QStringLiteral("stamp")]
                               .toMap();
    EXPECT_EQ(stamp[QStringLiteral("sec")].toInteger(), 1'700'000'007) << topic;
    EXPECT_EQ(stamp[QStringLiteral("nanosec")].toInteger(), 250'000'000) << topic;
  }
}

TEST(Onlookers, ARosThatGoesIsNamedAndToldAgainWhenItIsBack) {
  RosbridgeEmulator ros;
  Told told({ros.url().toString().toStdString()});
  ASSERT_TRUE(told.becomes(DeviceRole::ToRos, DeviceState::Ready));
  told.onlookers->tell(at(1.0, 8.0));
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
  told.onlookers->tell(at(1.0, 8.0));
  Viewer viewer(told.port);
  ASSERT_TRUE(viewer.hears(2));
  EXPECT_TRUE(waitUntil(
      [&] { return told.status(DeviceRole::ToFoxglove).detail.starts_with("one looks on"); }));
  viewer.send({{"op", "subscribe"},
               {"subscriptions",
                json::array({{{"id", 7}, {"channelId", 1}}, {{"id", 8}, {"channelId", 2}}})}});
  ASSERT_TRUE(waitUntil([&] { return viewer.frames.size() == 1; }));  // the map
  told.onlookers->tell(at(2.5, 8.0));
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
  told.onlookers->tell(at(1.0, 8.0));
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

TEST(Onlookers, WhatCannotBeIsSaidAndEndsNothing) {
  QTcpServer other;
  ASSERT_TRUE(other.listen(QHostAddress::LocalHost));
  Told told({"http://nowhere", other.serverPort()});
  EXPECT_TRUE(told.becomes(DeviceRole::ToRos, DeviceState::Lost));
  EXPECT_TRUE(told.becomes(DeviceRole::ToFoxglove, DeviceState::Lost));
  EXPECT_NE(told.status(DeviceRole::ToFoxglove).detail.find("cannot be opened"), std::string::npos);
  told.onlookers->tell(at(1.0, 8.0));
}

}  // namespace
}  // namespace handmap
