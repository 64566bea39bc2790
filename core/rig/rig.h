// What a robot's sensors are and where they are connected: a rig, and its file (JSON).
//
//   {"format": "handmap-rig", "version": 1,          required; of the rest what there is
//    "name": "Cart with a laser",
//    "range_limit_m": 30,                            1 … 200; nothing farther is measured, nor
//                                                    beyond what the scanner says it reaches
//    "camera":   {"kind": "video",                   or "firewire" (Bumblebee: "device" is its
//                                                    number or "first"), "vision" (GigE, USB3)
//                 "device": "/dev/video0"            both images in one, side by side; or
//                 "left": "…", "right": "…",         two devices; each also a file or a URL
//                 "ros": "ws://host:9090",           left and right are topics: CompressedImage,
//                                                    of a Foxglove bridge Image too
//                 "calibration": "calib.yml",        of OpenCV, or calib.txt of KITTI: rectified;
//                                                    of "ros" absent: camera_info beside the topics
//                 "width": 1280, "height": 480,      what to ask the device for
//                 "rate_hz": 15,
//                 "right_delay_ms": 0,               the right image is taken so much later
//                 "right_first": false,              of "device": the right image is on the left
//                 "mount": {"x_m", "y_m", "z_m", "pitch_deg", "yaw_deg"}},
//    "head":     {"port": "/dev/ttyUSB0@9600"},      PTU-D46; needs a camera
//    "scanner":  {"kind": "hokuyo"|"rplidar"|"ros"|"ros-cloud",
//                 "port": "…", "topic": "/scan",   LaserScan or PointCloud2
//                 "mount": {"x_m", "y_m", "z_m", "yaw_deg"}},
//    "odometry": {"kind": "lines"|"ros"|"visual"|"scan"|"none", "port": "…", "topic": "/odom"},
//                                                    absent: visual or scan
//    "stops":    {"pans_deg": [-150, -90, …], "standing_s": 1, "every_m": 1, "automatic": true,
//                 "topic": "/look_around"},          an Empty there asks; of odometry "ros"
//    "ros":      1,                                  where it is not 2
//    "publish":  {"ros": "ws://host:9090",           tells pose and map to ROS,
//                 "tf": true,                        and where its odometry lies on the map
//                 "foxglove": 8765,                  a port where Foxglove may look on,
//                 "beyond_this_machine": false,      also from other machines
//                 "origins": ["https://…"]},         and from these web pages
//    "record":   "recordings"}                       a folder; each run gets a new one inside
//
// Paths count from the folder of the file. "port": "/dev/ttyUSB0@115200", "tcp://host:port"; of
// "ros" a rosbridge, "ws://host:9090", or a Foxglove bridge, "foxglove://host:8765".
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/recording/calibration.h"
#include "core/recording/camera.h"
#include "core/recording/observation.h"

namespace handmap {

/// How a camera is connected: by OpenCV, IIDC on FireWire, GigE or USB3 Vision; or not at all.
enum class CameraKind { Video, FireWire, Vision, Virtual };

struct CameraRig {
  CameraKind kind = CameraKind::Video;
  std::string left;                   ///< device, file or URL
  std::string right;                  ///< empty: `left` gives both images side by side
  std::string ros;                    ///< a bridge: `left` and `right` are topics behind it
  std::filesystem::path calibration;  ///< absolute, or relative to the working folder; of `ros`
                                      ///< empty: the robot tells it
  CameraMount mount{0.0, 0.0, kDefaultCameraHeight, 0.0, 0.0};
  int width = 0;  ///< of the image as the device gives it; 0: as it likes
  int height = 0;
  double rate_hz = 0.0;  ///< 0: as it likes
  double right_delay_s = 0.0;
  bool right_first = false;            ///< of one device: the halves are the other way round
  std::optional<StereoCamera> optics;  ///< Virtual: rectified; no calibration is read
  bool operator==(const CameraRig& other) const;
};

struct HeadRig {
  std::string port;
  bool operator==(const HeadRig&) const = default;
};

/// Of a planar scanner in the robot frame: metres, radians.
struct ScannerMount {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double yaw = 0.0;
  bool operator==(const ScannerMount&) const = default;
};

/// Ros: sensor_msgs/LaserScan; RosCloud: sensor_msgs/PointCloud2.
enum class ScannerKind { Hokuyo, Rplidar, Ros, RosCloud, Virtual };

struct ScannerRig {
  ScannerKind kind = ScannerKind::Hokuyo;
  std::string port;
  std::string topic;  ///< Ros, RosCloud
  ScannerMount mount;
  bool isRos() const { return kind == ScannerKind::Ros || kind == ScannerKind::RosCloud; }
  bool operator==(const ScannerRig&) const = default;
};

/// Visual and Scan: computed from what the camera or the scanner sees.
enum class OdometryRigKind { None, Lines, Ros, Visual, Scan, Virtual };

struct OdometryRig {
  OdometryRigKind kind = OdometryRigKind::None;
  std::string port;
  std::string topic;  ///< Ros
  bool operator==(const OdometryRig&) const = default;

  /// A device tells it.
  bool isMeasured() const {
    return kind == OdometryRigKind::Lines || kind == OdometryRigKind::Ros ||
           kind == OdometryRigKind::Virtual;
  }
};

/// Of a robot with a head: it stops and looks around.
struct StopRig {
  std::vector<double> pans;  ///< radians, positive to the left, in the order they are driven to
  double standing_s = 1.0;   ///< so long without motion is a stop
  double every_m = 1.0;      ///< from the stop before; at less it is the same stop
  bool automatic = true;     ///< false: only when asked to
  std::string topic;         ///< of the robot's ROS, by which it asks; empty: none
  bool operator==(const StopRig&) const = default;
};
/// All around, within the ±159° of a PTU-D46.
StopRig sixPans();

/// Who is told of a run: where the robot is, and what the drawing became.
struct PublishRig {
  std::string ros;   ///< a bridge; empty: none
  int foxglove = 0;  ///< port; 0: nothing listens
  bool beyond_this_machine = false;
  std::vector<std::string> origins = {};  ///< of web pages that may look on, beside Foxglove's own
  bool tf = true;  ///< to ROS also map → odom; false: somebody else tells it
  bool operator==(const PublishRig&) const = default;
};

struct Rig {
  std::string name;
  double range_limit_m = kUsualReach_m;
  std::optional<CameraRig> camera;  ///< exactly one of camera and scanner
  std::optional<HeadRig> head;
  std::optional<ScannerRig> scanner;
  OdometryRig odometry;
  std::optional<StopRig> stops;  ///< where there is a head
  int ros_version = 2;
  PublishRig publish;
  std::filesystem::path record;  ///< empty: not recorded
  bool operator==(const Rig&) const = default;
};

/// Throws BadInput with file and key: also for a key that is not known (a misspelt one would be
/// without effect) and for parts that do not go together.
Rig readRig(const std::filesystem::path& path);
/// `folder`: from where its relative paths count.
Rig parseRig(const std::string& text, const std::string& source,
             const std::filesystem::path& folder);
/// The text that reads back as the same rig. Paths inside of `folder` become relative to it.
std::string formatRig(const Rig& rig, const std::filesystem::path& folder);

}  // namespace handmap
