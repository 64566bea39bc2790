#include <QCryptographicHash>
#include <QTcpServer>
#include <QTcpSocket>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "core/base/error.h"
#include "drivers/emulators/ros_emulated_messages.h"
#include "drivers/emulators/rosbridge_emulator.h"
#include "drivers/rosbridge/ros_devices.h"
#include "drivers/rosbridge/ros_publisher.h"
#include "drivers/rosbridge/rosbridge_client.h"
#include "tests/drivers/devices/peer.h"
#include "tests/drivers/devices/waiting.h"

namespace handmap {
namespace {

using test::Peer;
using test::StateLog;
using test::waitUntil;

std::shared_ptr<RosbridgeClient> clientOf(const RosbridgeEmulator& server,
                                          RosbridgeForm form = RosbridgeForm::Raw,
                                          RosVersion ros = RosVersion::Ros2) {
  return std::make_shared<RosbridgeClient>(RosbridgeOptions{server.url(), ros, form});
}

struct Odometry {
  explicit Odometry(const std::shared_ptr<RosbridgeClient>& client)
      : device(client, QStringLiteral("/odom"), QStringLiteral("/look"), startedRigClock()),
        log(device) {
    QObject::connect(&device, &OdometrySensor::lookAsked, &device, [this] { ++looks; });
    QObject::connect(&device, &OdometrySensor::moved, &device,
                     [this](double time_s, const Pose2& pose) {
                       EXPECT_GT(time_s, last_s);
                       last_s = time_s;
                       last = pose;
                       ++count;
                     });
  }
  RosOdometry device;
  StateLog log;
  Pose2 last;
  double last_s = -1.0;
  int count = 0;
  int looks = 0;
};

/// Sends odometry while it waits.
bool movesUntil(RosbridgeEmulator& server, const std::function<bool()>& holds,
                RosVersion ros = RosVersion::Ros2) {
  static const RigClock kClock = startedRigClock();
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, &server, [&] {
    const double stamp_s = 1.7e9 + kClock();
    server.publish(QStringLiteral("/odom"), emulated::odometry(stamp_s, {1.5, -2.0, 0.5}, ros));
  });
  timer.start(20);
  return waitUntil(holds);
}

TEST(RosbridgeClient, OtherAddressesAreRefused) {
  for (const char* url : {"", "http://host:9090", "ws://", "host:9090", "/dev/ttyUSB0"}) {
    EXPECT_THROW(RosbridgeClient(RosbridgeOptions{QUrl(QString::fromLatin1(url))}), Error) << url;
  }
}

class RosbridgeOf : public testing::TestWithParam<std::tuple<RosbridgeForm, RosVersion, int>> {};

TEST_P(RosbridgeOf, OdometryComes) {
  const auto [form, ros, fragment_bytes] = GetParam();
  RosbridgeEmulator server;
  server.setFragmentSize(fragment_bytes);
  Odometry odometry(clientOf(server, form, ros));
  odometry.device.open();
  ASSERT_TRUE(movesUntil(
      server, [&] { return odometry.count >= 5; }, ros));
  EXPECT_TRUE(odometry.log.is(DeviceState::Ready));
  EXPECT_NEAR(odometry.last.x, 1.5, 1e-9);
  EXPECT_NEAR(odometry.last.heading, 0.5, 1e-9);
  EXPECT_EQ(server.typeOf(QStringLiteral("/odom")).toStdString(),
            ros == RosVersion::Ros1 ? "nav_msgs/Odometry" : "nav_msgs/msg/Odometry");
  EXPECT_EQ(odometry.looks, 0);
  server.publish(QStringLiteral("/look"), QCborMap());
  EXPECT_TRUE(waitUntil([&] { return odometry.looks == 1; }));
  odometry.device.close();
  EXPECT_TRUE(waitUntil([&] { return !server.hasSubscriber(QStringLiteral("/odom")); }));
}

INSTANTIATE_TEST_SUITE_P(Forms, RosbridgeOf,
                         testing::Values(std::tuple(RosbridgeForm::Raw, RosVersion::Ros2, 0),
                                         std::tuple(RosbridgeForm::Cbor, RosVersion::Ros2, 0),
                                         std::tuple(RosbridgeForm::Json, RosVersion::Ros2, 0),
                                         std::tuple(RosbridgeForm::Json, RosVersion::Ros1, 50),
                                         std::tuple(RosbridgeForm::Raw, RosVersion::Ros1, 0)));

TEST(Rosbridge, OneThatKnowsNoRawMessagesIsAskedForCbor) {
  RosbridgeEmulator server;
  server.setKnowsRaw(false);
  Odometry odometry(clientOf(server));
  odometry.device.open();
  ASSERT_TRUE(movesUntil(
      server, [&] { return server.formOf(QStringLiteral("/odom")) == RosbridgeForm::Cbor; }));
  const int before = odometry.count;
  EXPECT_TRUE(movesUntil(server, [&] { return odometry.count > before + 2; }));
  EXPECT_TRUE(odometry.log.is(DeviceState::Ready));
}

TEST(Rosbridge, ScansCloudsAndPairsOfImagesComeOverOneConnection) {
  for (const auto form : {RosbridgeForm::Raw, RosbridgeForm::Cbor, RosbridgeForm::Json}) {
    RosbridgeEmulator server;
    const auto client = clientOf(server, form);
    const RigClock clock = startedRigClock();
    RosScanner laser(client, QStringLiteral("/scan"), RosScanner::Kind::LaserScan, clock);
    RosScanner lidar(client, QStringLiteral("/points"), RosScanner::Kind::PointCloud2, clock);
    RosCamera camera(client, QStringLiteral("/left"), QStringLiteral("/right"), clock);
    std::size_t rays = 0;
    std::size_t points = 0;
    int pairs = 0;
    QObject::connect(
        &laser, &RangeSensor::scanned, &laser, [&](double, const std::vector<RangePoint>& scan) {
          rays = static_cast<std::size_t>(std::count_if(scan.begin(), scan.end(), isMeasured));
        });
    double reach_m = 0.0;
    QObject::connect(&laser, &RangeSensor::reaches, &laser,
                     [&](double range_m) { reach_m = range_m; });
    QObject::connect(&lidar, &RangeSensor::scanned, &lidar,
                     [&](double, const std::vector<RangePoint>& scan) { points = scan.size(); });
    QObject::connect(&camera, &PairCamera::pairTaken, &camera,
                     [&](double, const cv::Mat& left, const cv::Mat& right) {
                       EXPECT_EQ(left.at<uchar>(0, 0) + 1, right.at<uchar>(0, 0));
                       ++pairs;
                     });
    const StateLog log(camera);
    for (Device* device : {static_cast<Device*>(&laser), static_cast<Device*>(&lidar),
                           static_cast<Device*>(&camera)}) {
      device->open();
    }
    ASSERT_TRUE(waitUntil([&] { return server.hasSubscriber(QStringLiteral("/right")); }));
    std::vector<float> ranges(100, 2.0F);
    ranges[5] = std::numeric_limits<float>::infinity();
    const std::vector<RangePoint> cloud(1000, RangePoint{1, 2, 3, 1});
    const auto picture = [](int grey) {
      std::vector<unsigned char> file;
      cv::imencode(".png", cv::Mat(8, 8, CV_8UC1, cv::Scalar(grey)), file);
      return QByteArray(reinterpret_cast<const char*>(file.data()),
                        static_cast<qsizetype>(file.size()));
    };
    for (int i = 0; i < 10; ++i) {
      const double stamp_s = 50.0 + i;
      server.publish(QStringLiteral("/scan"),
                     emulated::laserScan(stamp_s, ranges, RosVersion::Ros2));
      server.publish(QStringLiteral("/points"),
                     emulated::pointCloud(stamp_s, cloud, RosVersion::Ros2));
      server.publish(QStringLiteral("/right"),
                     emulated::compressedImage(stamp_s, picture(2 * i + 1), RosVersion::Ros2));
      if (i == 5) continue;  // one left image is lost
      server.publish(QStringLiteral("/left"),
                     emulated::compressedImage(stamp_s + 0.001, picture(2 * i), RosVersion::Ros2));
    }
    ASSERT_TRUE(waitUntil([&] { return pairs == 9; })) << pairs;
    EXPECT_EQ(rays, 99U);
    EXPECT_EQ(reach_m, 30.0);
    EXPECT_EQ(points, 1000U);
    EXPECT_EQ(camera.unpaired(), 1);
    EXPECT_TRUE(log.is(DeviceState::Ready));
  }
}

TEST(Rosbridge, MessagesThatNoRosbridgeSendsAreSaidAndDoNoHarm) {
  RosbridgeEmulator server;
  Odometry odometry(clientOf(server));
  odometry.device.open();
  ASSERT_TRUE(movesUntil(server, [&] { return odometry.count >= 3; }));
  const QByteArray deep = "{\"op\":" + QByteArray(100'000, '[');
  for (const QByteArray& bad :
       {QByteArray("nonsense"), QByteArray("{}"), QByteArray("{\"op\":5}"), deep,
        QByteArray(R"({"op":"publish","topic":"/odom","msg":{"pose":[]}})"),
        QByteArray(R"({"op":"fragment","id":"1","num":5,"total":2,"data":""})"),
        QByteArray(R"({"op":"status","level":"error","msg":"no such topic"})")}) {
    for (int i = 0; i < 5; ++i) server.sendRaw(bad, false);
  }
  server.sendRaw(QByteArray(100'000, '\x81'), true);
  ASSERT_TRUE(waitUntil([&] { return odometry.log.is(DeviceState::Degraded); }));
  const int before = odometry.count;
  EXPECT_TRUE(movesUntil(server, [&] { return odometry.count > before; }));
  EXPECT_TRUE(movesUntil(server, [&] { return odometry.log.is(DeviceState::Ready); }));
}

TEST(Rosbridge, AMessageTooLargeEndsTheConnectionAndItIsMadeAgain) {
  RosbridgeEmulator server;
  Odometry odometry(clientOf(server));
  odometry.device.open();
  ASSERT_TRUE(movesUntil(server, [&] { return odometry.count >= 3; }));
  server.sendRaw(QByteArray(40 << 20, ' '), true);
  ASSERT_TRUE(waitUntil([&] { return odometry.log.was(DeviceState::Lost); }));
  const int before = odometry.count;
  EXPECT_TRUE(movesUntil(server, [&] { return odometry.count > before; }));
}

/// Counts what Qt complains of while it lives.
class Complaints {
 public:
  Complaints() { count() = 0; }
  ~Complaints() { qInstallMessageHandler(before_); }
  static int& count() {
    static int complaints = 0;
    return complaints;
  }

 private:
  QtMessageHandler before_ =
      qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString& text) {
        std::cerr << text.toStdString() << '\n';
        ++count();
      });
};

TEST(Rosbridge, AServerThatGoesIsSaidAndFoundAgain) {
  const Complaints complaints;
  RosbridgeEmulator server;
  Odometry odometry(clientOf(server));
  odometry.device.open();
  for (int round = 0; round < 2; ++round) {
    const int before = odometry.count;
    ASSERT_TRUE(movesUntil(server, [&] { return odometry.count > before + 2; }));
    server.unplug();
    ASSERT_TRUE(waitUntil([&] { return odometry.log.is(DeviceState::Lost); }));
    EXPECT_NE(odometry.log.details.back().find("127.0.0.1"), std::string::npos);
    server.plug();
  }
  const int before = odometry.count;
  ASSERT_TRUE(movesUntil(server, [&] { return odometry.count > before + 2; }));
  ASSERT_TRUE(waitUntil([&] { return odometry.log.is(DeviceState::Degraded); }));  // silence
  EXPECT_NE(odometry.log.details.back().find("/odom"), std::string::npos);
  EXPECT_EQ(Complaints::count(), 0);
}

TEST(Rosbridge, ATopicThatNobodySendsIsSaidAndHeardWhenItComes) {
  RosbridgeEmulator server;
  Odometry odometry(clientOf(server));
  odometry.device.open();
  ASSERT_TRUE(waitUntil([&] { return server.hasSubscriber(QStringLiteral("/odom")); }));
  ASSERT_TRUE(waitUntil([&] {
    return odometry.log.details.back() ==
           "nothing has come of /odom yet: is that its name, and is it sent?";
  }));
  EXPECT_TRUE(odometry.log.is(DeviceState::Connecting));
  ASSERT_TRUE(movesUntil(server, [&] { return odometry.log.is(DeviceState::Ready); }));
  ASSERT_TRUE(waitUntil([&] { return odometry.log.is(DeviceState::Degraded); }));
  EXPECT_EQ(odometry.log.details.back(), "nothing comes of /odom any more");
  EXPECT_TRUE(movesUntil(server, [&] { return odometry.log.is(DeviceState::Ready); }));
}

std::shared_ptr<const Map> oneBuilding() {
  auto map = std::make_shared<Map>();
  map->buildings.resize(1);
  map->buildings[0].id = "A";
  map->buildings[0].shape = Rectangle{{10.0, 5.0}, 8.0, 4.0, 0.0};
  return map;
}

TEST(Rosbridge, TheFramesOfTheOdometryAreNamedAlsoWhereTheBaseBeginsAnew) {
  RosbridgeEmulator server;
  const RigClock clock = startedRigClock();
  RosOdometry device(clientOf(server), QStringLiteral("/odom"), {}, clock);
  std::vector<OdometryFrames> named;
  Pose2 told;
  QObject::connect(&device, &OdometrySensor::framed, &device,
                   [&](const OdometryFrames& frames) { named.push_back(frames); });
  QObject::connect(&device, &OdometrySensor::moved, &device,
                   [&](double, const Pose2& pose) { told = pose; });
  device.open();
  Pose2 base{50.0, 3.0, 0.5};
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, &server, [&] {
    server.publish(QStringLiteral("/odom"),
                   emulated::odometry(1.7e9 + clock(), base, RosVersion::Ros2));
  });
  timer.start(20);
  ASSERT_TRUE(waitUntil([&] { return named.size() == 1; }));
  EXPECT_EQ(named[0].odometry, "base") << "as the emulator calls it";
  EXPECT_EQ(named[0].base, "base");
  EXPECT_EQ(named[0].origin, Pose2{});
  base = {0.0, 0.0, 0.0};
  ASSERT_TRUE(waitUntil([&] { return named.size() == 2; }));
  base = {1.0, 0.0, 0.0};
  const Pose2 there = named[1].origin * base;
  EXPECT_TRUE(waitUntil([&] { return (told.position() - there.position()).norm() < 1e-6; }));
  EXPECT_NEAR(there.x, 50.0 + std::cos(0.5), 1e-6);
}

/// Lets in whoever comes, takes nothing of what it is sent then, and pings.
class DeafBridge {
 public:
  DeafBridge() {
    server_.listen(QHostAddress::LocalHost);
    QObject::connect(&server_, &QTcpServer::newConnection, &server_, [this] {
      socket_ = server_.nextPendingConnection();
      QObject::connect(socket_, &QTcpSocket::readyRead, &server_, [this] { letIn(); });
    });
  }
  QUrl url() const { return QUrl(QStringLiteral("ws://127.0.0.1:%1").arg(server_.serverPort())); }
  bool isLetGo() const { return let_in_ && socket_->state() == QAbstractSocket::UnconnectedState; }
  /// So many bytes were sent.
  qint64 ping() {
    if (!let_in_ || socket_->bytesToWrite() > 1 << 20) return 0;
    QByteArray flood;
    for (int i = 0; i < 1000; ++i) flood += QByteArray("\x89\x7d", 2) + QByteArray(125, 'x');
    return socket_->write(flood);
  }

 private:
  void letIn() {
    if (let_in_) return;
    request_ += socket_->readAll();
    if (!request_.contains("\r\n\r\n")) return;
    const qsizetype at = request_.indexOf("Sec-WebSocket-Key: ") + 19;
    const QByteArray key = request_.mid(at, request_.indexOf("\r\n", at) - at);
    const QByteArray proof = QCryptographicHash::hash(key + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11",
                                                      QCryptographicHash::Sha1);
    socket_->write(
        "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\n"
        "Connection: Upgrade\r\nSec-WebSocket-Accept: " +
        proof.toBase64() + "\r\n\r\n");
    socket_->setReadBufferSize(1);
    let_in_ = true;
  }
  QTcpServer server_;
  QTcpSocket* socket_ = nullptr;
  QByteArray request_;
  bool let_in_ = false;
};

TEST(RosbridgeClient, AServerThatPingsAndDoesNotReadIsLetGo) {
  DeafBridge bridge;
  const auto client = std::make_shared<RosbridgeClient>(RosbridgeOptions{bridge.url()});
  QString why;
  QObject::connect(client.get(), &RosbridgeClient::lost, client.get(),
                   [&](const QString& said) { why = said; });
  client->open();
  ASSERT_TRUE(waitUntil([&] { return client->isConnected(); }));
  qint64 sent = 0;
  EXPECT_TRUE(waitUntil([&] {
    sent += bridge.ping();
    return !why.isEmpty();
  }));
  EXPECT_TRUE(why.contains(QLatin1String("does not take"))) << why.toStdString();
  EXPECT_LT(sent, 200 << 20) << "bytes of pings, each with its pong";
  EXPECT_TRUE(waitUntil([&] { return bridge.isLetGo(); }));
  client->close();
}

TEST(RosPublisher, WhoHearsGetsPosesAndTheMapAlsoAfterALoss) {
  RosbridgeEmulator server;
  QStringList heard;
  QObject::connect(&server, &RosbridgeEmulator::published, &server,
                   [&](const QString& topic, const QCborMap&) { heard << topic; });
  const auto client = clientOf(server);
  RosPublisher publisher(client);
  publisher.publishMap(5.0, oneBuilding());  // before there is a connection
  ASSERT_TRUE(waitUntil([&] { return heard.contains(QStringLiteral("/handmap/buildings")); }));
  EXPECT_TRUE(heard.contains(QStringLiteral("/handmap/map")));
  publisher.publishPose(5.0, {1.0, 2.0, 3.0}, Eigen::Matrix3d::Identity());
  ASSERT_TRUE(waitUntil([&] { return heard.contains(QStringLiteral("/handmap/pose")); }));
  heard.clear();
  server.unplug();
  ASSERT_TRUE(waitUntil([&] { return !client->isConnected(); }));
  server.plug();
  EXPECT_TRUE(waitUntil([&] { return heard.contains(QStringLiteral("/handmap/map")); }));
}

TEST(RosbridgePeer, RoslibSendsOdometryAndHearsWhatIsPublished) {
  const std::string missing = Peer::missing(QStringLiteral("roslib"));
  if (!missing.empty()) GTEST_SKIP() << missing;
  RosbridgeEmulator server;
  const auto client = clientOf(server);
  Odometry odometry(client);
  odometry.device.open();
  Peer peer(QStringLiteral("roslib_peer.mjs"), {server.url().toString()});
  ASSERT_TRUE(waitUntil([&] { return odometry.count >= 20; }, Peer::kPatience_ms));
  EXPECT_EQ(odometry.last.y, -2.0);
  EXPECT_NEAR(std::abs(odometry.last.heading), kPi, 1e-9);
  ASSERT_TRUE(waitUntil([&] { return server.hasSubscriber(QStringLiteral("/scan")); }));
  RosPublisher publisher(client);
  ASSERT_TRUE(waitUntil([&] { return client->isConnected(); }));
  publisher.publishMap(5.0, oneBuilding());
  publisher.publishPose(1.7e9, {7.5, 2.0, 3.0}, 0.25 * Eigen::Matrix3d::Identity());
  server.publish(QStringLiteral("/scan"),
                 emulated::laserScan(1.0, {1.0F, 2.0F, 3.0F, 4.5F}, RosVersion::Ros2));
  EXPECT_TRUE(peer.says("POSE 7.5 0.25 map true")) << peer.said;
  EXPECT_TRUE(peer.says("GRID true 512 0.25")) << peer.said;  // 8 m × 4 m
  EXPECT_TRUE(peer.says("MARKERS 2 5")) << peer.said;
  EXPECT_TRUE(peer.says("SCAN Float32Array 4 4.5")) << peer.said;
}

}  // namespace
}  // namespace handmap
