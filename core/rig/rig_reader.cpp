#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/geometry/pose2.h"
#include "core/rig/rig_names.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kMaxBytes = 1u << 20;
constexpr std::size_t kMaxTextBytes = 4096;
constexpr double kMaxMount_m = 100.0;
constexpr double kMaxAngle_deg = 360.0;
constexpr double kMaxPan_deg = 180.0;
constexpr std::size_t kMaxPans = 36;
constexpr double kMaxDelay_ms = 1000.0;
constexpr int kMaxPixels = 16384;
constexpr double kMaxRate_hz = 1000.0;
constexpr double kMaxStanding_s = 60.0;
constexpr double kMaxEvery_m = 1000.0;
constexpr int kMaxPort = 65535;
constexpr std::size_t kMaxOrigins = 100;

template <typename Kind, std::size_t count>
Kind kindOf(const JsonValue& json, const std::array<std::pair<Kind, const char*>, count>& known) {
  const std::string word = json.text(kMaxTextBytes);
  std::string words;
  for (const auto& [kind, name] : known) {
    if (word == name) return kind;
    words += (words.empty() ? "" : ", ") + std::string(name);
  }
  json.fail(phrase("one of {}", words));
}

void onlyKnown(const JsonValue& json, const std::vector<std::string_view>& known) {
  const auto others = json.others(known);
  if (others.empty()) return;
  const std::string key = others.begin()->first;
  json.at(key).fail(phrase("an unknown key"), phrase("one of {}", fmt::join(known, ", ")));
}

void readNumber(const JsonValue& json, const char* key, double low, double high, double& value) {
  if (const auto found = json.find(key)) value = found->number(low, high);
}

void readAngle(const JsonValue& json, const char* key, double& radians) {
  if (const auto found = json.find(key)) {
    radians = toRadians(found->number(-kMaxAngle_deg, kMaxAngle_deg));
  }
}

std::string neededText(const JsonValue& json, const char* key) {
  std::string text = json.at(key).text(kMaxTextBytes);
  if (trimmed(text).empty()) json.at(key).fail(phrase("some text"));
  return text;
}

fs::path pathFrom(const JsonValue& json, const fs::path& folder) {
  const fs::path path = json.text(kMaxTextBytes);
  if (path.empty()) json.fail(phrase("a path"));
  return (folder / path).lexically_normal();
}

CameraRig readCamera(const JsonValue& json, const fs::path& folder) {
  onlyKnown(json, {"kind", "device", "left", "right", "ros", "calibration", "width", "height",
                   "rate_hz", "right_delay_ms", "right_first", "mount"});
  CameraRig camera;
  if (const auto kind = json.find("kind")) camera.kind = kindOf(*kind, kCameras);
  const bool side_by_side = json.find("device").has_value();
  if (json.find("ros")) {
    camera.ros = neededText(json, "ros");
    for (const char* key :
         {"kind", "device", "right_first", "width", "height", "rate_hz", "right_delay_ms"}) {
      if (json.find(key))
        json.at(key).fail(phrase("it beside \"ros\""), phrase("the topics \"left\" and \"right\""));
    }
  }
  if (side_by_side && (json.find("left") || json.find("right"))) {
    json.fail(phrase("\"device\" and \"left\" or \"right\""),
              phrase("\"device\" (both images in one) or \"left\" and \"right\""));
  }
  camera.left = neededText(json, side_by_side ? "device" : "left");
  if (!side_by_side) camera.right = neededText(json, "right");
  if (const auto first = json.find("right_first")) {
    if (!side_by_side) {
      first->fail(phrase("it beside two cameras"), phrase("\"device\" (both images in one)"));
    }
    camera.right_first = first->flag();
  }
  if (camera.kind == CameraKind::FireWire && !side_by_side) {
    json.fail(phrase("no \"device\""), phrase("one: a stereo head that sends both images in one"));
  }
  // Over ROS the robot may tell it.
  if (camera.ros.empty() || json.find("calibration")) {
    camera.calibration = pathFrom(json.at("calibration"), folder);
  }
  const auto pixels = [&](const char* key, int& value) {
    if (const auto found = json.find(key)) value = static_cast<int>(found->integer(1, kMaxPixels));
  };
  pixels("width", camera.width);
  pixels("height", camera.height);
  readNumber(json, "rate_hz", 0.0, kMaxRate_hz, camera.rate_hz);
  double delay_ms = 0.0;
  readNumber(json, "right_delay_ms", -kMaxDelay_ms, kMaxDelay_ms, delay_ms);
  camera.right_delay_s = delay_ms / 1000.0;
  if (const auto mount = json.find("mount")) {
    onlyKnown(*mount, {"x_m", "y_m", "z_m", "pitch_deg", "yaw_deg"});
    readNumber(*mount, "x_m", -kMaxMount_m, kMaxMount_m, camera.mount.x);
    readNumber(*mount, "y_m", -kMaxMount_m, kMaxMount_m, camera.mount.y);
    readNumber(*mount, "z_m", -kMaxMount_m, kMaxMount_m, camera.mount.z);
    readAngle(*mount, "pitch_deg", camera.mount.pitch);
    readAngle(*mount, "yaw_deg", camera.mount.yaw);
  }
  return camera;
}

ScannerRig readScanner(const JsonValue& json) {
  onlyKnown(json, {"kind", "port", "topic", "mount"});
  ScannerRig scanner;
  scanner.kind = kindOf(json.at("kind"), kScanners);
  scanner.port = neededText(json, "port");
  if (scanner.isRos()) scanner.topic = neededText(json, "topic");
  if (const auto mount = json.find("mount")) {
    onlyKnown(*mount, {"x_m", "y_m", "z_m", "yaw_deg"});
    readNumber(*mount, "x_m", -kMaxMount_m, kMaxMount_m, scanner.mount.x);
    readNumber(*mount, "y_m", -kMaxMount_m, kMaxMount_m, scanner.mount.y);
    readNumber(*mount, "z_m", -kMaxMount_m, kMaxMount_m, scanner.mount.z);
    readAngle(*mount, "yaw_deg", scanner.mount.yaw);
  }
  return scanner;
}

OdometryRig readOdometry(const JsonValue& json) {
  onlyKnown(json, {"kind", "port", "topic"});
  OdometryRig odometry;
  odometry.kind = kindOf(json.at("kind"), kOdometries);
  if (odometry.isMeasured()) odometry.port = neededText(json, "port");
  if (odometry.kind == OdometryRigKind::Ros) odometry.topic = neededText(json, "topic");
  return odometry;
}

StopRig readStops(const JsonValue& json) {
  onlyKnown(json, {"pans_deg", "standing_s", "every_m", "automatic", "topic"});
  StopRig stops = sixPans();
  if (const auto pans = json.find("pans_deg")) {
    stops.pans.clear();
    for (const JsonValue& pan : pans->items(kMaxPans)) {
      stops.pans.push_back(toRadians(pan.number(-kMaxPan_deg, kMaxPan_deg)));
    }
    if (stops.pans.empty()) pans->fail(phrase("at least one pan"));
  }
  readNumber(json, "standing_s", 0.1, kMaxStanding_s, stops.standing_s);
  readNumber(json, "every_m", 0.1, kMaxEvery_m, stops.every_m);
  if (const auto automatic = json.find("automatic")) stops.automatic = automatic->flag();
  if (json.find("topic")) stops.topic = neededText(json, "topic");
  return stops;
}

PublishRig readPublish(const JsonValue& json) {
  onlyKnown(json, {"ros", "tf", "foxglove", "beyond_this_machine", "origins"});
  PublishRig publish;
  if (json.find("ros")) publish.ros = neededText(json, "ros");
  if (const auto tf = json.find("tf")) publish.tf = tf->flag();
  if (const auto port = json.find("foxglove")) {
    publish.foxglove = static_cast<int>(port->integer(1, kMaxPort));
  }
  if (const auto beyond = json.find("beyond_this_machine")) {
    publish.beyond_this_machine = beyond->flag();
  }
  if (const auto origins = json.find("origins")) {
    for (const JsonValue& origin : origins->items(kMaxOrigins)) {
      publish.origins.push_back(origin.text(kMaxTextBytes));
    }
  }
  return publish;
}

/// What each part for itself is right about may still not go together.
void checkTogether(const Rig& rig, const std::string& source) {
  if (rig.camera.has_value() == rig.scanner.has_value()) {
    throwBadInput(
        source, "",
        rig.camera ? phrase("a camera and a scanner") : phrase("neither camera nor scanner"),
        phrase("one of them: what the robot sees with"));
  }
  if (rig.head && !rig.camera) {
    throwBadInput(source, "head", phrase("no camera on it"), phrase("a camera"));
  }
  if (rig.stops && !rig.head) {
    throwBadInput(source, "stops", phrase("no head"), phrase("a head to look around"));
  }
  if (rig.head && !rig.odometry.isMeasured()) {
    throwBadInput(
        source, "odometry", phrase("nothing that measures it"),
        phrase("lines or ros: a robot that stops to look around sees too little in common "
               "between two stops"));
  }
  if (rig.stops && !rig.stops->topic.empty() && rig.odometry.kind != OdometryRigKind::Ros) {
    throwBadInput(source, "stops.topic", phrase("odometry that is not by ROS"),
                  phrase("odometry \"ros\""));
  }
  if (rig.odometry.kind == OdometryRigKind::Visual && !rig.camera) {
    throwBadInput(source, "odometry.kind", phrase("visual without a camera"), phrase("a camera"));
  }
  if (rig.odometry.kind == OdometryRigKind::Scan && !rig.scanner) {
    throwBadInput(source, "odometry.kind", phrase("scan without a scanner"), phrase("a scanner"));
  }
}

}  // namespace

StopRig sixPans() {
  StopRig stops;
  for (const double pan_deg : {-150.0, -90.0, -30.0, 30.0, 90.0, 150.0}) {
    stops.pans.push_back(toRadians(pan_deg));
  }
  return stops;
}

Rig parseRig(const std::string& text, const std::string& source, const fs::path& folder) {
  const auto parsed = parseJson(text, source);
  const JsonValue json(parsed, source);
  if (json.at("format").text(kMaxTextBytes) != "handmap-rig") {
    json.at("format").fail("\"handmap-rig\"");
  }
  const auto version = json.at("version").integer(1, INT64_MAX);
  if (version > kRigVersion) {
    throw Error(
        ErrorCode::BadInput,
        phrase("{}: version: found {}, this program reads up to {}", source, version, kRigVersion),
        phrase("update the program to use this rig"));
  }
  onlyKnown(json, {"format", "version", "name", "range_limit_m", "camera", "head", "scanner",
                   "odometry", "stops", "ros", "publish", "record"});
  Rig rig;
  rig.name = json.textOr("name", kMaxTextBytes, "");
  readNumber(json, "range_limit_m", kLeastReach_m, kMostReach_m, rig.range_limit_m);
  if (const auto camera = json.find("camera")) rig.camera = readCamera(*camera, folder);
  if (const auto head = json.find("head")) {
    onlyKnown(*head, {"port"});
    rig.head = HeadRig{neededText(*head, "port")};
    rig.stops = sixPans();
  }
  if (const auto scanner = json.find("scanner")) rig.scanner = readScanner(*scanner);
  if (const auto odometry = json.find("odometry")) {
    rig.odometry = readOdometry(*odometry);
  } else {
    rig.odometry.kind = rig.scanner ? OdometryRigKind::Scan : OdometryRigKind::Visual;
  }
  if (const auto stops = json.find("stops")) rig.stops = readStops(*stops);
  if (const auto ros = json.find("ros")) rig.ros_version = static_cast<int>(ros->integer(1, 2));
  if (const auto publish = json.find("publish")) rig.publish = readPublish(*publish);
  if (const auto record = json.find("record")) rig.record = pathFrom(*record, folder);
  checkTogether(rig, source);
  return rig;
}

Rig readRig(const fs::path& path) {
  Rig rig = parseRig(readFile(path, kMaxBytes), path.string(), path.parent_path());
  if (rig.name.empty()) rig.name = path.stem().string();
  return rig;
}

}  // namespace handmap
