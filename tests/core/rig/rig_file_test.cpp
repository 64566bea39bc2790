#include <filesystem>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/geometry/pose2.h"
#include "core/rig/rig.h"

namespace handmap {
namespace {

Rig parsed(const std::string& rest) {
  return parseRig(R"({"format": "handmap-rig", "version": 1, )" + rest + "}", "rig.json",
                  "/robots");
}

std::string refusal(const std::string& rest) {
  try {
    parsed(rest);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::BadInput);
    return error.what();
  }
  return "accepted";
}

constexpr auto kCamera = R"("camera": {"left": "a", "right": "b", "calibration": "c.yml"})";
constexpr auto kScanner = R"("scanner": {"kind": "hokuyo", "port": "/dev/ttyACM0"})";

TEST(RigFile, ReadsALaserOnACart) {
  const Rig rig = parsed(R"("name": "cart", "range_limit_m": 30,
      "scanner": {"kind": "rplidar", "port": "/dev/ttyUSB0@115200",
                  "mount": {"x_m": 0.2, "y_m": -0.1, "z_m": 0.5, "yaw_deg": 90}},
      "odometry": {"kind": "ros", "port": "ws://robot:9090", "topic": "/odom"},
      "record": "runs")");
  EXPECT_EQ(rig.name, "cart");
  EXPECT_EQ(rig.range_limit_m, 30.0);
  ASSERT_TRUE(rig.scanner);
  EXPECT_EQ(rig.scanner->kind, ScannerKind::Rplidar);
  EXPECT_EQ(rig.scanner->mount, (ScannerMount{0.2, -0.1, 0.5, kPi / 2.0}));
  EXPECT_EQ(rig.odometry.kind, OdometryRigKind::Ros);
  EXPECT_EQ(rig.odometry.topic, "/odom");
  EXPECT_EQ(rig.record, "/robots/runs");
}

TEST(RigFile, AHeadLooksAroundInSixPans) {
  const Rig rig = parsed(std::string(kCamera) + R"(, "head": {"port": "/dev/ttyUSB0"},
      "odometry": {"kind": "lines", "port": "tcp://base:7000"})");
  ASSERT_TRUE(rig.stops);
  EXPECT_EQ(*rig.stops, sixPans());
  ASSERT_EQ(rig.stops->pans.size(), 6U);
  EXPECT_EQ(rig.camera->calibration, "/robots/c.yml");
}

TEST(RigFile, WithoutOdometryWhatItSeesTellsTheMotion) {
  EXPECT_EQ(parsed(kCamera).odometry.kind, OdometryRigKind::Visual);
  EXPECT_EQ(parsed(kScanner).odometry.kind, OdometryRigKind::Scan);
}

TEST(RigFile, WhatIsWrittenReadsBackTheSame) {
  Rig rig = parsed(std::string(kCamera) + R"(, "head": {"port": "/dev/ttyUSB0"},
      "odometry": {"kind": "lines", "port": "tcp://base:7000"}, "record": "runs",
      "stops": {"pans_deg": [0, 33.3, -179.9], "standing_s": 2, "every_m": 3, "automatic": false})");
  rig.camera->mount = {0.1, 0.2, 1.3, toRadians(-3.7), toRadians(12.1)};
  rig.camera->right_delay_s = 0.004;
  rig.camera->width = 640;
  const std::string text = formatRig(rig, "/robots");
  EXPECT_NE(text.find("\"calibration\": \"c.yml\""), std::string::npos) << text;
  EXPECT_EQ(parseRig(text, "rig.json", "/robots"), rig);
}

TEST(RigFile, ALookAroundMayBeAskedForOverRos) {
  const std::string robot = std::string(kCamera) + R"(, "head": {"port": "/dev/ttyUSB0"},
      "stops": {"topic": "/look"}, )";
  const Rig rig =
      parsed(robot + R"("odometry": {"kind": "ros", "port": "ws://rover:9090", "topic": "/odom"})");
  EXPECT_EQ(rig.stops->topic, "/look");
  EXPECT_EQ(parseRig(formatRig(rig, "/robots"), "rig.json", "/robots"), rig);
  EXPECT_THROW(parsed(robot + R"("odometry": {"kind": "lines", "port": "tcp://base:7000"})"),
               Error);
}

TEST(RigFile, CamerasOverRosAndWhoIsToldAreWrittenToo) {
  const Rig rig = parsed(R"("camera": {"ros": "ws://rover:9090", "left": "/left", "right": "/right",
      "calibration": "c.yml"}, "publish": {"ros": "ws://rover:9090", "foxglove": 8765,
      "origins": ["https://viewer.example"]})");
  EXPECT_EQ(rig.camera->ros, "ws://rover:9090");
  EXPECT_EQ(rig.publish, (PublishRig{"ws://rover:9090", 8765, false, {"https://viewer.example"}}));
  Rig without_tf = rig;
  without_tf.publish.tf = false;
  EXPECT_EQ(parseRig(formatRig(without_tf, {}), "rig", {}).publish, without_tf.publish);
  EXPECT_EQ(parseRig(formatRig(rig, "/robots"), "rig.json", "/robots"), rig);
  EXPECT_NE(refusal(R"("camera": {"ros": "ws://x:1", "left": "a", "right": "b", "width": 640,
                    "calibration": "c"})")
                .find("camera.width"),
            std::string::npos);
  EXPECT_NE(refusal(std::string(kScanner) + R"(, "publish": {"foxglove": 70000})")
                .find("publish.foxglove"),
            std::string::npos);
}

TEST(RigFile, OfCamerasOverRosTheRobotMayTellTheCalibration) {
  const Rig rig = parsed(R"("camera": {"ros": "foxglove://robot", "left": "/l", "right": "/r"})");
  EXPECT_TRUE(rig.camera->calibration.empty());
  EXPECT_EQ(parseRig(formatRig(rig, "/robots"), "rig.json", "/robots"), rig);
  EXPECT_EQ(refusal(R"("camera": {"left": "a", "right": "b"})"),
            "rig.json: camera.calibration: found nothing, expected this key");
}

TEST(RigFile, AStereoHeadOnFireWireAndAPairOfVisionCameras) {
  const Rig head = parsed(R"("camera": {"kind": "firewire", "device": "first",
      "right_first": true, "calibration": "c.yml"})");
  EXPECT_EQ(head.camera->kind, CameraKind::FireWire);
  EXPECT_TRUE(head.camera->right_first);
  const Rig pair = parsed(R"("camera": {"kind": "vision", "left": "Basler-1", "right": "Basler-2",
      "calibration": "c.yml"})");
  EXPECT_EQ(pair.camera->kind, CameraKind::Vision);
  for (const Rig& rig : {head, pair}) {
    EXPECT_EQ(parseRig(formatRig(rig, "/robots"), "rig.json", "/robots"), rig);
  }
  EXPECT_NE(refusal(R"("camera": {"kind": "usb4", "device": "a", "calibration": "c"})")
                .find("expected one of video, firewire, vision"),
            std::string::npos);
  EXPECT_NE(refusal(R"("camera": {"kind": "firewire", "left": "a", "right": "b",
                    "calibration": "c"})")
                .find("no \"device\""),
            std::string::npos);
  EXPECT_NE(refusal(R"("camera": {"left": "a", "right": "b", "right_first": true,
                    "calibration": "c"})")
                .find("camera.right_first"),
            std::string::npos);
}

TEST(RigFile, RefusesWhatDoesNotGoTogether) {
  EXPECT_EQ(refusal(R"("name": "x")"),
            "rig.json: found neither camera nor scanner, expected one of them: what the robot sees "
            "with");
  EXPECT_NE(refusal(std::string(kCamera) + ", " + kScanner).find("a camera and a scanner"),
            std::string::npos);
  EXPECT_NE(refusal(std::string(kScanner) + R"(, "head": {"port": "x"})").find("no camera on it"),
            std::string::npos);
  EXPECT_NE(refusal(std::string(kCamera) + R"(, "head": {"port": "x"})").find("odometry"),
            std::string::npos);
  EXPECT_NE(refusal(std::string(kScanner) + R"(, "odometry": {"kind": "visual"})").find("a camera"),
            std::string::npos);
  EXPECT_NE(refusal(std::string(kCamera) + R"(, "odometry": {"kind": "scan"})").find("a scanner"),
            std::string::npos);
}

TEST(RigFile, NamesTheKeyThatIsWrong) {
  EXPECT_EQ(refusal(R"("scanner": {"kind": "sick", "port": "x"})"),
            "rig.json: scanner.kind: found \"sick\" (string), expected one of hokuyo, rplidar, "
            "ros, ros-cloud");
  EXPECT_NE(refusal(R"("scanner": {"kind": "hokuyo", "prot": "x"})")
                .find("scanner.prot: found an unknown key, expected one of kind, port"),
            std::string::npos);
  EXPECT_NE(refusal(R"("scanner": {"kind": "ros", "port": "ws://x"})").find("scanner.topic"),
            std::string::npos);
  EXPECT_NE(refusal(R"("camera": {"device": "a", "left": "b", "calibration": "c"})")
                .find("both images in one"),
            std::string::npos);
  EXPECT_NE(refusal(R"("camera": {"device": "a", "calibration": "c", "width": 1e9})")
                .find("camera.width"),
            std::string::npos);
  EXPECT_NE(refusal(std::string(kScanner) + R"(, "range_limit_m": 1000)").find("range_limit_m"),
            std::string::npos);
}

TEST(RigFile, TheExamplesCanBeRead) {
  const std::filesystem::path folder = HANDMAP_RIGS;
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    EXPECT_NO_THROW(readRig(entry.path())) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 3);
}

}  // namespace
}  // namespace handmap
