#include "drivers/connected/connected_devices.h"

#include <cstdint>
#include <map>

#include "drivers/camera/video_camera.h"
#include "drivers/foxglove_bridge/ros_address.h"
#include "drivers/odometry_lines/line_odometry.h"
#include "drivers/pan_tilt/ptu_head.h"
#include "drivers/rosbridge/ros_devices.h"
#include "drivers/scanner/hokuyo_scanner.h"
#include "drivers/scanner/rplidar_scanner.h"

namespace handmap {

namespace {

/// Each waits by a seed of its own before it tries again.
constexpr std::uint64_t kRosSeed = 11;
constexpr std::uint64_t kScannerSeed = 12;
constexpr std::uint64_t kHeadSeed = 13;
constexpr std::uint64_t kOdometrySeed = 14;

class Maker {
 public:
  Maker(const Rig& rig, RigMonitor& monitor) : rig_(rig), monitor_(monitor) {}

  RigDevices make() { return {odometry(), scanner(), camera(), head()}; }

 private:
  std::unique_ptr<PairCamera> camera() {
    if (!rig_.camera) return nullptr;
    if (!rig_.camera->ros.empty()) {
      return std::make_unique<RosCamera>(ros(rig_.camera->ros), topic(rig_.camera->left),
                                         topic(rig_.camera->right), monitor_.clock(),
                                         rig_.camera->calibration.empty()
                                             ? RosCamera::Calibration::OfRobot
                                             : RosCamera::Calibration::OfRig);
    }
    return std::make_unique<VideoCamera>(
        *rig_.camera, monitor_.clock(),
        [&monitor = monitor_](const std::string& reason) { monitor.refused(reason); });
  }

  std::unique_ptr<OdometrySensor> odometry() {
    const OdometryRig& odometry = rig_.odometry;
    if (odometry.kind == OdometryRigKind::Lines) {
      return std::make_unique<LineOdometry>(parsePortAddress(odometry.port, LineOdometry::kBaud),
                                            monitor_.clock(), kOdometrySeed);
    }
    if (odometry.kind != OdometryRigKind::Ros) return nullptr;
    return std::make_unique<RosOdometry>(ros(odometry.port), topic(odometry.topic),
                                         topic(rig_.stops ? rig_.stops->topic : std::string()),
                                         monitor_.clock());
  }

  std::unique_ptr<RangeSensor> scanner() {
    if (!rig_.scanner) return nullptr;
    const ScannerRig& scanner = *rig_.scanner;
    switch (scanner.kind) {
      case ScannerKind::Hokuyo:
        return std::make_unique<HokuyoScanner>(
            parsePortAddress(scanner.port, HokuyoScanner::kBaud, HokuyoScanner::kTcpPort),
            monitor_.clock(), kScannerSeed);
      case ScannerKind::Rplidar:
        return std::make_unique<RplidarScanner>(
            parsePortAddress(scanner.port, RplidarScanner::kBaud), monitor_.clock(), kScannerSeed);
      case ScannerKind::Ros:
        return std::make_unique<RosScanner>(ros(scanner.port), topic(scanner.topic),
                                            RosScanner::Kind::LaserScan, monitor_.clock());
      case ScannerKind::RosCloud:
        return std::make_unique<RosScanner>(ros(scanner.port), topic(scanner.topic),
                                            RosScanner::Kind::PointCloud2, monitor_.clock());
      case ScannerKind::Virtual:
        break;
    }
    return nullptr;
  }

  std::unique_ptr<PanTiltHead> head() {
    if (!rig_.head) return nullptr;
    return std::make_unique<PtuHead>(parsePortAddress(rig_.head->port, PtuHead::kBaud),
                                     monitor_.clock(), PtuOptions{}, kHeadSeed);
  }

  static QString topic(const std::string& name) { return QString::fromStdString(name); }

  /// One connection for all devices behind one address.
  std::shared_ptr<RosClient> ros(const std::string& url) {
    auto& client = ros_clients_[url];
    if (!client) {
      const RosVersion version = rig_.ros_version == 1 ? RosVersion::Ros1 : RosVersion::Ros2;
      client = rosClientAt(url, version, kRosSeed);
    }
    return client;
  }

  const Rig& rig_;
  RigMonitor& monitor_;
  std::map<std::string, std::shared_ptr<RosClient>> ros_clients_;
};

}  // namespace

MakeDevices connectedDevices() {
  return [](const Rig& rig, RigMonitor& monitor) { return Maker(rig, monitor).make(); };
}

}  // namespace handmap
