#include <QTimer>
#include <algorithm>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "core/base/error.h"
#include "drivers/emulators/foxglove_bridge_emulator.h"
#include "drivers/emulators/ros_emulated_messages.h"
#include "drivers/foxglove_bridge/foxglove_bridge_client.h"
#include "drivers/foxglove_bridge/ros_address.h"
#include "drivers/rosbridge/ros_devices.h"
#include "drivers/rosbridge/ros_publisher.h"
#include "tests/drivers/devices/waiting.h"

namespace handmap {
namespace {

using test::StateLog;
using test::waitUntil;

const QString kOdom = QStringLiteral("/odom");

std::shared_ptr<RosClient> clientOf(const FoxgloveBridgeEmulator& bridge) {
  return std::make_shared<FoxgloveBridgeClient>(bridge.url());
}

/// Odometry behind a bridge that is there from the start.
class FoxgloveBridge : public testing::Test {
 protected:
  FoxgloveBridge() {
    bridge_.offer(kOdom, "nav_msgs/msg/Odometry");
    QObject::connect(&device_, &OdometrySensor::moved, &device_, [this](double, const Pose2& pose) {
      last_ = pose;
      ++count_;
    });
    device_.open();
  }
  /// Sends odometry while it waits.
  bool movesUntil(const std::function<bool()>& holds) {
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &bridge_, [this] {
      bridge_.publish(kOdom,
                      emulated::odometry(1.7e9 + clock_(), {1.5, -2.0, 0.5}, RosVersion::Ros2));
    });
    timer.start(20);
    return waitUntil(holds);
  }
  bool movesOn() {
    const int before = count_;
    return movesUntil([&] { return count_ > before + 2; });
  }

  FoxgloveBridgeEmulator bridge_;
  RigClock clock_ = startedRigClock();
  RosOdometry device_{clientOf(bridge_), kOdom, {}, clock_};
  StateLog log_{device_};
  Pose2 last_;
  int count_ = 0;
};

TEST(FoxgloveBridgeClient, OtherAddressesAreRefused) {
  for (const char* url : {"", "ws://host:8765", "foxglove://", "foxglove:host", "/dev/ttyUSB0"}) {
    EXPECT_THROW(FoxgloveBridgeClient(QUrl(QString::fromLatin1(url))), Error) << url;
  }
  EXPECT_NE(dynamic_cast<FoxgloveBridgeClient*>(
                rosClientAt("foxglove://robot", RosVersion::Ros2, 1).get()),
            nullptr);
  EXPECT_THROW(rosClientAt("http://robot", RosVersion::Ros2, 1), Error);
}

TEST_F(FoxgloveBridge, OdometryComes) {
  ASSERT_TRUE(movesOn());
  EXPECT_TRUE(log_.is(DeviceState::Ready));
  EXPECT_NEAR(last_.x, 1.5, 1e-12);
  EXPECT_NEAR(last_.heading, 0.5, 1e-12);
  EXPECT_EQ(bridge_.subprotocol(), "foxglove.sdk.v1");
  device_.close();
  EXPECT_TRUE(waitUntil([&] { return !bridge_.hasSubscriber(kOdom); }));
}

TEST_F(FoxgloveBridge, ATopicThatGoesIsSaidAndTakenUpAgain) {
  ASSERT_TRUE(movesOn());
  bridge_.withdraw(kOdom);
  ASSERT_TRUE(waitUntil([&] { return log_.is(DeviceState::Degraded); }));
  EXPECT_NE(log_.details.back().find("/odom"), std::string::npos);
  bridge_.offer(kOdom, "nav_msgs/msg/Odometry");
  EXPECT_TRUE(movesOn());
  EXPECT_TRUE(movesUntil([&] { return log_.is(DeviceState::Ready); }));
}

TEST_F(FoxgloveBridge, ABridgeThatGoesIsSaidAndFoundAgain) {
  for (int round = 0; round < 2; ++round) {
    ASSERT_TRUE(movesOn());
    bridge_.unplug();
    ASSERT_TRUE(waitUntil([&] { return log_.is(DeviceState::Lost); }));
    EXPECT_NE(log_.details.back().find("127.0.0.1"), std::string::npos);
    bridge_.plug();
  }
  EXPECT_TRUE(movesOn());
}

TEST_F(FoxgloveBridge, DroppedMessagesCostThemselvesAlone) {
  int sent = 0;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, &bridge_, [&] {
    if (++sent % 2 == 0) return;
    bridge_.publish(kOdom, emulated::odometry(1.7e9 + clock_(), {}, RosVersion::Ros2));
  });
  timer.start(20);
  ASSERT_TRUE(waitUntil([&] { return count_ > 10; }));
  EXPECT_TRUE(log_.is(DeviceState::Ready));
  EXPECT_FALSE(log_.was(DeviceState::Degraded));
}

TEST_F(FoxgloveBridge, MessagesThatNoBridgeSendsAreSaidAndDoNoHarm) {
  ASSERT_TRUE(movesOn());
  for (const QByteArray& bad :
       {QByteArray("nonsense"), QByteArray("{}"), QByteArray(R"({"op":"advertise"})"),
        "{\"op\":" + QByteArray(100'000, '['),
        QByteArray(R"({"op":"advertise","channels":[{"id":-1,"topic":"/odom"}]})"),
        QByteArray(R"({"op":"status","level":2,"message":"no such topic"})")}) {
    for (int i = 0; i < 5; ++i) bridge_.sendRaw(bad, false);
  }
  for (const QByteArray& bad : {QByteArray("\1"), QByteArray("\1\1\0\0\0", 5),
                                QByteArray("\1\1\0\0\0\0\0\0\0\0\0\0\0xy", 15),
                                QByteArray("\7\0\0", 3), QByteArray(100'000, '\xff')}) {
    for (int i = 0; i < 5; ++i) bridge_.sendRaw(bad, true);
  }
  ASSERT_TRUE(waitUntil([&] { return log_.is(DeviceState::Degraded); }));
  EXPECT_TRUE(movesOn());
  EXPECT_TRUE(movesUntil([&] { return log_.is(DeviceState::Ready); }));
}

TEST_F(FoxgloveBridge, AMessageTooLargeEndsTheConnectionAndItIsMadeAgain) {
  ASSERT_TRUE(movesOn());
  bridge_.sendRaw(QByteArray(40 << 20, ' '), true);
  ASSERT_TRUE(waitUntil([&] { return log_.was(DeviceState::Lost); }));
  EXPECT_TRUE(movesOn());
}

TEST(FoxgloveBridgeOf, JsonItIsSaidThatItCannotBeRead) {
  FoxgloveBridgeEmulator bridge;
  bridge.setEncoding(QStringLiteral("json"));
  bridge.offer(kOdom, "nav_msgs/msg/Odometry");
  RosOdometry device(clientOf(bridge), kOdom, {}, startedRigClock());
  const StateLog log(device);
  device.open();
  ASSERT_TRUE(waitUntil([&] { return log.is(DeviceState::Degraded); }));
  EXPECT_EQ(log.details.back(), "/odom: found \"json\", expected \"cdr\", \"ros1\"");
}

QByteArray png(const cv::Mat& image) {
  std::vector<unsigned char> file;
  cv::imencode(".png", image, file);
  return {reinterpret_cast<const char*>(file.data()), static_cast<qsizetype>(file.size())};
}

TEST(FoxgloveBridgeOf, ScansCloudsAndPairsComeOverOneConnection) {
  FoxgloveBridgeEmulator bridge;
  bridge.offer("/scan", "sensor_msgs/msg/LaserScan");
  bridge.offer("/points", "sensor_msgs/msg/PointCloud2");
  bridge.offer("/left", "sensor_msgs/msg/CompressedImage");
  bridge.offer("/right", "sensor_msgs/msg/Image");
  const auto client = clientOf(bridge);
  const RigClock clock = startedRigClock();
  RosScanner laser(client, "/scan", RosScanner::Kind::LaserScan, clock);
  RosScanner lidar(client, "/points", RosScanner::Kind::PointCloud2, clock);
  RosCamera camera(client, "/left", "/right", clock);
  std::size_t rays = 0;
  std::size_t points = 0;
  int pairs = 0;
  QObject::connect(&laser, &RangeSensor::scanned, &laser,
                   [&](double, const std::vector<RangePoint>& scan) { rays = scan.size(); });
  QObject::connect(&lidar, &RangeSensor::scanned, &lidar,
                   [&](double, const std::vector<RangePoint>& scan) { points = scan.size(); });
  QObject::connect(&camera, &PairCamera::pairTaken, &camera,
                   [&](double, const cv::Mat& left, const cv::Mat& right) {
                     EXPECT_EQ(left.at<uchar>(0, 0) + 1, right.at<uchar>(0, 0));
                     ++pairs;
                   });
  for (Device* device : {static_cast<Device*>(&laser), static_cast<Device*>(&lidar),
                         static_cast<Device*>(&camera)}) {
    device->open();
  }
  ASSERT_TRUE(waitUntil([&] { return bridge.hasSubscriber("/right"); }));
  const std::vector<RangePoint> cloud(1000, RangePoint{1, 2, 3, 1});
  for (int i = 0; i < 10; ++i) {
    const double stamp_s = 50.0 + i;
    bridge.publish("/scan",
                   emulated::laserScan(stamp_s, std::vector<float>(100, 2.0F), RosVersion::Ros2));
    bridge.publish("/points", emulated::pointCloud(stamp_s, cloud, RosVersion::Ros2));
    bridge.publish(
        "/left", emulated::compressedImage(stamp_s, png(cv::Mat(8, 8, CV_8UC1, cv::Scalar(2 * i))),
                                           RosVersion::Ros2));
    bridge.publish("/right", emulated::image(stamp_s, cv::Mat(8, 8, CV_8UC1, cv::Scalar(2 * i + 1)),
                                             RosVersion::Ros2));
  }
  ASSERT_TRUE(waitUntil([&] { return pairs == 10; })) << pairs;
  EXPECT_EQ(rays, 100U);
  EXPECT_EQ(points, 1000U);
  EXPECT_EQ(camera.unpaired(), 0);
}

TEST(FoxgloveBridgeOf, PosesAndTheMapAreToldAlsoAfterALoss) {
  FoxgloveBridgeEmulator bridge;
  std::map<QString, std::pair<QString, QCborMap>> heard;
  QObject::connect(&bridge, &FoxgloveBridgeEmulator::published, &bridge,
                   [&](const QString& topic, const QString& type, const QCborMap& message) {
                     heard[topic] = {type, message};
                   });
  const auto client = clientOf(bridge);
  RosPublisher publisher(client);
  auto map = std::make_shared<Map>();
  map->buildings.resize(1);
  map->buildings[0].shape = Rectangle{{10.0, 5.0}, 8.0, 4.0, 0.0};
  publisher.publishMap(5.0, map);  // before there is a connection
  ASSERT_TRUE(waitUntil([&] { return heard.contains("/handmap/buildings"); }));
  EXPECT_EQ(heard["/handmap/map"].first, "nav_msgs/msg/OccupancyGrid");
  const RosValue grid(heard["/handmap/map"].second, "/handmap/map");
  EXPECT_EQ(
      grid.at("info").at("width").integer(0, 1000) * grid.at("info").at("height").integer(0, 1000),
      grid.at("data").numbers(100'000).size());
  publisher.publishPose(5.0, {1.0, 2.0, 3.0}, Eigen::Matrix3d::Identity());
  ASSERT_TRUE(waitUntil([&] { return heard.contains("/handmap/pose"); }));
  EXPECT_NEAR(readPose(RosValue(heard["/handmap/pose"].second, "p")).pose.heading, 3.0, 1e-9);
  heard.clear();
  bridge.unplug();
  ASSERT_TRUE(waitUntil([&] { return !client->isConnected(); }));
  bridge.plug();
  EXPECT_TRUE(waitUntil([&] { return heard.contains("/handmap/map"); }));
}

TEST(FoxgloveBridgeOf, APoseThatIsGivenIsHeard) {
  FoxgloveBridgeEmulator bridge;
  bridge.offer("/initialpose", "geometry_msgs/msg/PoseWithCovarianceStamped");
  RosPublisher publisher(clientOf(bridge));
  std::optional<Pose2> given;
  QObject::connect(&publisher, &RosPublisher::poseGiven, &publisher,
                   [&](const Pose2& pose) { given = pose; });
  ASSERT_TRUE(waitUntil([&] { return bridge.hasSubscriber("/initialpose"); }));
  bridge.publish("/initialpose",
                 poseMessage({rosTimeOf(1.0)}, {4.0, 5.0, 0.5}, Eigen::Matrix3d::Zero()));
  ASSERT_TRUE(waitUntil([&] { return given.has_value(); }));
  EXPECT_NEAR(given->heading, 0.5, 1e-9);
}

}  // namespace
}  // namespace handmap
