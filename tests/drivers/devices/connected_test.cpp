// The devices that a rig file names, as they are made.
#include <QProcess>
#include <QRegularExpression>
#include <atomic>
#include <functional>
#include <set>
#include <string_view>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/recording/recording.h"
#include "drivers/connected/connected_devices.h"
#include "drivers/emulators/foxglove_bridge_emulator.h"
#include "drivers/emulators/hokuyo_emulator.h"
#include "drivers/emulators/odometry_emulator.h"
#include "drivers/emulators/ros_emulated_messages.h"
#include "drivers/emulators/rosbridge_emulator.h"
#include "drivers/live/live_source.h"
#include "drivers/live/rig_host.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/drivers/devices/waiting.h"

namespace handmap {
namespace {

QByteArray picture(int grey) {
  std::vector<unsigned char> file;
  cv::imencode(".png", cv::Mat(8, 8, CV_8UC1, cv::Scalar(grey)), file);
  return {reinterpret_cast<const char*>(file.data()), static_cast<qsizetype>(file.size())};
}

std::string bytesOf(const Observation& observation) {
  std::string text = fmt::format("{:.9f}", observation.time_s);
  text += fmt::format(" {:.9f}", observation.odometry.x);
  for (const View& view : observation.views) {
    for (const cv::Mat& image : {view.left, view.right}) {
      if (image.empty()) continue;
      const std::string_view bytes(image.ptr<char>(), image.total() * image.elemSize());
      text += fmt::format(" {:x}", std::hash<std::string_view>()(bytes));
    }
    if (!view.points) continue;
    for (const RangePoint& p : *view.points) text += fmt::format(" {} {}", p.x, p.y);
  }
  return text;
}

/// The first observations of a drive while `send` goes on telling.
std::vector<std::string> lived(const LiveJob& live, std::size_t count,
                               const std::function<void()>& send) {
  std::vector<std::string> seen;
  std::atomic<bool> done = false;
  std::thread run([&] {
    {
      const auto source = openLive(live, {});
      while (source && seen.size() < count) {
        const auto observation = source->next();
        if (!observation) break;
        seen.push_back(bytesOf(*observation));
      }
    }
    done = true;
  });
  test::waitUntil([&] {
    send();
    return done.load();
  });
  live.monitor->end();
  run.join();
  return seen;
}

std::vector<std::string> replayed(const std::filesystem::path& recording, std::size_t count) {
  std::vector<std::string> seen;
  const auto source = replay(openRecording(recording), {});
  while (seen.size() < count) {
    const auto observation = source->next();
    if (!observation) break;
    seen.push_back(bytesOf(*observation));
  }
  return seen;
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

/// `handmap-cli try` tells of each device what it gives; scans are seen though the wheels are dead.
TEST(ConnectedDevices, ARigIsTriedWithWheelsThatSayNothing) {
  HokuyoEmulator laser(EmulatedPort::Kind::Tcp, [](double) { return 3.0; });
  OdometryEmulator wheels(
      EmulatedPort::Kind::PseudoTerminal, [](double) { return Pose2{}; },
      OdometryEmulator::Form::Fields);
  wheels.setDead(true);
  const std::string rig = fmt::format(
      R"({{"format": "handmap-rig", "version": 1, "scanner": {{"kind": "hokuyo", "port": "{}"}},
          "odometry": {{"kind": "lines", "port": "{}"}}}})",
      laser.port().address(), wheels.port().address());
  {
    const auto monitor = std::make_shared<RigMonitor>();
    const RigHost host(parseRig(rig, "rig.json", "/"), connectedDevices(), monitor);
    EXPECT_TRUE(test::waitUntil([&] { return monitor->preview().number > 0; }));
    EXPECT_FALSE(monitor->preview().points.empty());
  }
  const test::TemporaryFolder folder;
  QProcess tried;
  tried.start(HANDMAP_CLI, {"try", QString::fromStdString(folder.write("rig.json", rig).string()),
                            "--for", "4"});
  ASSERT_TRUE(test::waitUntil([&] { return tried.state() == QProcess::NotRunning; }));
  const QString out = QString::fromUtf8(tried.readAllStandardOutput());
  EXPECT_EQ(tried.exitCode(), 3);
  const QRegularExpression scanner(
      "^scanner   ready      first data after \\d\\.\\d s, \\d+\\.\\d a second, \\d+ in all: "
      "Emulated$",
      QRegularExpression::MultilineOption);
  EXPECT_TRUE(scanner.match(out).hasMatch()) << out.toStdString();
  EXPECT_TRUE(out.contains("odometry  ") && out.contains("no data in 4 s")) << out.toStdString();
}

/// A pair of cameras behind a Foxglove bridge, in a rig that says nothing of their calibration.
class CamerasOfARobot : public testing::Test {
 protected:
  CamerasOfARobot() {
    for (const char* side : {"/left", "/right"}) {
      ros_.offer(QLatin1String(side) + "/image_raw", "sensor_msgs/msg/Image");
    }
    ros_.offer("/odom", "nav_msgs/msg/Odometry");
    const std::string url = ros_.url().toString().toStdString();
    live_.rig = parseRig(fmt::format(R"({{"format": "handmap-rig", "version": 1,
          "camera": {{"ros": "{}", "left": "/left/image_raw", "right": "/right/image_raw",
                      "mount": {{"z_m": 0.5}}}},
          "odometry": {{"kind": "ros", "port": "{}", "topic": "/odom"}}}})",
                                     url, url),
                         "rig.json", "/");
    live_.make = connectedDevices();
    live_.monitor = std::make_shared<RigMonitor>();
    cv::randu(picture_, 0, 255);
  }
  ~CamerasOfARobot() override { live_.monitor->end(); }

  void send() {
    const double now_s = 1.5e9 + live_.monitor->now();
    ros_.publish("/odom", emulated::odometry(now_s, {}, RosVersion::Ros2));
    for (const char* side : {"/left", "/right"}) {
      ros_.publish(QLatin1String(side) + "/image_raw",
                   emulated::image(now_s, picture_, RosVersion::Ros2));
    }
  }
  void tellCalibration(double baseline_m) {
    for (const auto& [topic, right_m] :
         {std::pair("/left/camera_info", 0.0), std::pair("/right/camera_info", baseline_m)}) {
      ros_.offer(topic, "sensor_msgs/msg/CameraInfo");
      ros_.publish(topic,
                   emulated::cameraInfo(picture_.size(), camera_, right_m, RosVersion::Ros2));
    }
  }
  std::string cameraSays() const {
    for (const DeviceStatus& device : live_.monitor->status().devices) {
      if (device.role == DeviceRole::Camera) return device.detail;
    }
    return "no camera";
  }

  FoxgloveBridgeEmulator ros_;
  LiveJob live_;
  StereoCamera camera_{90, 91, 63, 47, 0, {}};
  cv::Mat picture_ = cv::Mat(96, 128, CV_8UC1);
};

TEST_F(CamerasOfARobot, TheirCalibrationIsWhatTheRobotTells) {
  std::optional<StereoCamera> camera;
  std::atomic<bool> done = false;
  std::thread run([&] {
    if (const auto source = openLive(live_, {})) camera = source->info().camera;
    done = true;
  });
  EXPECT_TRUE(test::waitUntil([&] {
    send();
    tellCalibration(0.12);
    return done.load();
  }));
  live_.monitor->end();
  run.join();
  ASSERT_TRUE(camera);
  EXPECT_NEAR(camera->fx, 90.0, 1e-9);
  EXPECT_NEAR(camera->cy, 47.0, 1e-9);
  EXPECT_NEAR(camera->baseline, 0.12, 1e-9);
  EXPECT_EQ(camera->mount.z, 0.5);
  EXPECT_EQ(cameraSays(), "");
}

TEST_F(CamerasOfARobot, WhereNobodyTellsItItIsSaid) {
  const RigHost host(live_.rig, live_.make, live_.monitor);
  const auto says = [&](const std::string& words) {
    return test::waitUntil([&] {
      send();
      return cameraSays() == words;
    });
  };
  EXPECT_TRUE(says("nothing has come of /left/camera_info, and the rig names no calibration"))
      << cameraSays();
  tellCalibration(-0.12);
  const auto is_refused = [&] {
    send();
    tellCalibration(-0.12);
    return cameraSays().find("found a baseline of -0.12 m") != std::string::npos;
  };
  EXPECT_TRUE(test::waitUntil(is_refused)) << cameraSays();
}

/// A drive of a laser behind a Foxglove bridge, run as it comes and again from its recording.
TEST(ConnectedDevices, ADriveOverAFoxgloveBridgeReplaysTheSame) {
  FoxgloveBridgeEmulator ros;
  ros.offer("/scan", "sensor_msgs/msg/LaserScan");
  ros.offer("/odom", "nav_msgs/msg/Odometry");
  const std::string url = ros.url().toString().toStdString();
  LiveJob live;
  live.rig = parseRig(fmt::format(R"({{"format": "handmap-rig", "version": 1,
          "scanner": {{"kind": "ros", "port": "{}", "topic": "/scan"}},
          "odometry": {{"kind": "ros", "port": "{}", "topic": "/odom"}}}})",
                                  url, url),
                      "rig.json", "/");
  const test::TemporaryFolder folder;
  live.make = connectedDevices();
  live.monitor = std::make_shared<RigMonitor>();
  live.record = folder.path() / "drive";
  int sent = 0;
  const auto seen = lived(live, 20, [&] {
    const double now_s = 1.5e9 + live.monitor->now();
    ros.publish("/odom", emulated::odometry(now_s, {0.01 * sent++, 0.0, 0.0}, RosVersion::Ros2));
    const float range_m = 2.0F + 0.01F * static_cast<float>(sent % 50);
    if (sent % 4 == 0) {
      ros.publish("/scan",
                  emulated::laserScan(now_s, std::vector<float>(90, range_m), RosVersion::Ros2));
    }
  });
  ASSERT_EQ(seen.size(), 20U);
  EXPECT_EQ(replayed(live.record, seen.size()), seen);
}

TEST_F(CamerasOfARobot, LargeImagesReplayToTheSameBytes) {
  const test::TemporaryFolder folder;
  live_.record = folder.path() / "drive";
  camera_ = {900, 900, 640, 360, 0, {}};
  cv::Mat street(720, 1320, CV_8UC1);
  cv::randu(street, 0, 255);
  cv::GaussianBlur(street, street, {}, 4.0);
  cv::normalize(street, street, 0, 255, cv::NORM_MINMAX);
  int sent = 0;
  const auto seen = lived(live_, 12, [&] {
    picture_ = street(cv::Rect(sent++ % 40, 0, 1280, 720)).clone();
    if (sent < 10) tellCalibration(0.12);
    send();
    test::pass(30);
  });
  ASSERT_EQ(seen.size(), 12U);
  EXPECT_EQ(std::set(seen.begin(), seen.end()).size(), 12U);
  EXPECT_EQ(replayed(live_.record, seen.size()), seen);
}

}  // namespace
}  // namespace handmap
