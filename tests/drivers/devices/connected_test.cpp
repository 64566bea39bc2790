// The devices that a rig file names, as they are made.
#include <functional>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "drivers/connected/connected_devices.h"
#include "drivers/emulators/ros_emulated_messages.h"
#include "drivers/emulators/rosbridge_emulator.h"
#include "drivers/live/rig_host.h"
#include "tests/drivers/devices/waiting.h"

namespace handmap {
namespace {

QByteArray picture(int grey) {
  std::vector<unsigned char> file;
  cv::imencode(".png", cv::Mat(8, 8, CV_8UC1, cv::Scalar(grey)), file);
  return {reinterpret_cast<const char*>(file.data()), static_cast<qsizetype>(file.size())};
}

TEST(ConnectedDevices, TwoCamerasOverRosGivePairs) {
  RosbridgeEmulator ros;
  const Rig rig =
      parseRig(fmt::format(R"({{"format": "handmap-rig", "version": 1, "camera": {{"ros": "{}",
          "left": "/left", "right": "/right", "calibration": "calib.yml"}}}})",
                           ros.url().toString().toStdString()),
               "rig.json", "/");
  RigMonitor monitor;
  const RigDevices devices = connectedDevices()(rig, monitor);
  ASSERT_NE(devices.camera, nullptr);
  int pairs = 0;
  QObject::connect(devices.camera.get(), &PairCamera::pairTaken, devices.camera.get(),
                   [&pairs](double, const cv::Mat& left, const cv::Mat& right) {
                     EXPECT_EQ(left.at<uchar>(0, 0) + 1, right.at<uchar>(0, 0));
                     ++pairs;
                   });
  devices.camera->open();
  ASSERT_TRUE(test::waitUntil([&] { return ros.hasSubscriber(QStringLiteral("/right")); }));
  const auto send = [&ros](const QString& topic, int i, int grey) {
    ros.publish(topic, emulated::compressedImage(50.0 + 0.1 * i, picture(grey), RosVersion::Ros2));
  };
  for (int i = 0; i < 10; ++i) {
    send(QStringLiteral("/left"), i, i);
    send(QStringLiteral("/right"), i, i + 1);
    test::pass(20);
  }
  EXPECT_TRUE(test::waitUntil([&] { return pairs >= 5; }));
}

TEST(ConnectedDevices, ARobotOverRosKeepsItsTime) {
  RosbridgeEmulator ros;
  const std::string url = ros.url().toString().toStdString();
  const Rig rig = parseRig(fmt::format(R"({{"format": "handmap-rig", "version": 1,
          "scanner": {{"kind": "ros", "port": "{}", "topic": "/scan"}},
          "odometry": {{"kind": "ros", "port": "{}", "topic": "/odom"}}}})",
                                       url, url),
                           "rig.json", "/");
  const auto monitor = std::make_shared<RigMonitor>();
  RigHost host(rig, connectedDevices(), monitor);
  ASSERT_TRUE(test::waitUntil([&] {
    return ros.hasSubscriber(QStringLiteral("/scan")) && ros.hasSubscriber(QStringLiteral("/odom"));
  }));
  const auto robot_s = [&] { return 1'500'000'000.0 + monitor->now(); };
  const auto drives_until = [&](const std::function<bool()>& holds) {
    return test::waitUntil([&] {
      ros.publish(QStringLiteral("/odom"), emulated::odometry(robot_s(), {}, RosVersion::Ros2));
      return holds();
    });
  };
  ASSERT_TRUE(drives_until([&] { return monitor->status().devices.at(0).count > 0; }));
  const double then = robot_s();
  ros.publish(QStringLiteral("/scan"),
              emulated::laserScan(then, std::vector<float>(8, 2.0F), RosVersion::Ros2));
  ASSERT_TRUE(drives_until([&] { return monitor->status().observation_age_s.has_value(); }));
  const auto observation = host.next({});
  ASSERT_TRUE(observation);
  EXPECT_NEAR(monitor->robotTime(observation->time_s), then, 1e-6);
}

}  // namespace
}  // namespace handmap
