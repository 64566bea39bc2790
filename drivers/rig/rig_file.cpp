#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/text.h"
#include "core/geometry/pose2.h"
#include "drivers/rig/rig.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

constexpr int kVersion = 1;
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

constexpr std::array kScanners = {
    std::pair(ScannerKind::Hokuyo, "hokuyo"), std::pair(ScannerKind::Rplidar, "rplidar"),
    std::pair(ScannerKind::Ros, "ros"), std::pair(ScannerKind::RosCloud, "ros-cloud")};
constexpr std::array kOdometries = {
    std::pair(OdometryRigKind::None, "none"), std::pair(OdometryRigKind::Lines, "lines"),
    std::pair(OdometryRigKind::Ros, "ros"), std::pair(OdometryRigKind::Visual, "visual"),
    std::pair(OdometryRigKind::Scan, "scan")};

template <typename Kind, std::size_t count>
Kind kindOf(const JsonValue& json, const std::array<std::pair<Kind, const char*>, count>& known) {
  const std::string word = json.text(kMaxTextBytes);
  std::string words;
  for (const auto& [kind, name] : known) {
    if (word == name) return kind;
    words += (words.empty() ? "" : ", ") + std::string(name);
  }
  json.fail("one of " + words);
}

template <typename Kind, std::size_t count>
std::string nameOf(Kind kind, const std::array<std::pair<Kind, const char*>, count>& known) {
  for (const auto& [its, name] : known) {
    if (kind == its) return name;
  }
  throw Error(ErrorCode::RunFailed, "a virtual rig has no file");
}

void onlyKnown(const JsonValue& json, const std::vector<std::string_view>& known) {
  const auto others = json.others(known);
  if (others.empty()) return;
  const std::string key = others.begin()->first;
  json.at(key).fail("an unknown key", fmt::format("one of {}", fmt::join(known, ", ")));
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
  const std::string text = json.at(key).text(kMaxTextBytes);
  if (trimmed(text).empty()) json.at(key).fail("some text");
  return text;
}

fs::path pathFrom(const JsonValue& json, const fs::path& folder) {
  const fs::path path = json.text(kMaxTextBytes);
  if (path.empty()) json.fail("a path");
  return (folder / path).lexically_normal();
}

CameraRig readCamera(const JsonValue& json, const fs::path& folder) {
  onlyKnown(json, {"device", "left", "right", "calibration", "width", "height", "rate_hz",
                   "right_delay_ms", "mount"});
  CameraRig camera;
  const bool side_by_side = json.find("device").has_value();
  if (side_by_side && (json.find("left") || json.find("right"))) {
    json.fail("\"device\" and \"left\" or \"right\"",
              "\"device\" (both images in one) or \"left\" and \"right\"");
  }
  camera.left = neededText(json, side_by_side ? "device" : "left");
  if (!side_by_side) camera.right = neededText(json, "right");
  camera.calibration = pathFrom(json.at("calibration"), folder);
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
  onlyKnown(json, {"pans_deg", "standing_s", "every_m", "automatic"});
  StopRig stops = sixPans();
  if (const auto pans = json.find("pans_deg")) {
    stops.pans.clear();
    for (const JsonValue& pan : pans->items(kMaxPans)) {
      stops.pans.push_back(toRadians(pan.number(-kMaxPan_deg, kMaxPan_deg)));
    }
    if (stops.pans.empty()) pans->fail("at least one pan");
  }
  readNumber(json, "standing_s", 0.1, kMaxStanding_s, stops.standing_s);
  readNumber(json, "every_m", 0.1, kMaxEvery_m, stops.every_m);
  if (const auto automatic = json.find("automatic")) stops.automatic = automatic->flag();
  return stops;
}

/// What each part for itself is right about may still not go together.
void checkTogether(const Rig& rig, const std::string& source) {
  if (rig.camera.has_value() == rig.scanner.has_value()) {
    throwBadInput(source, "", rig.camera ? "a camera and a scanner" : "neither camera nor scanner",
                  "one of them: what the robot sees with");
  }
  if (rig.head && !rig.camera) throwBadInput(source, "head", "no camera on it", "a camera");
  if (rig.stops && !rig.head) throwBadInput(source, "stops", "no head", "a head to look around");
  if (rig.head && !rig.odometry.isMeasured()) {
    throwBadInput(source, "odometry", "nothing that measures it",
                  "lines or ros: a robot that stops to look around sees too little in common "
                  "between two stops");
  }
  if (rig.odometry.kind == OdometryRigKind::Visual && !rig.camera) {
    throwBadInput(source, "odometry.kind", "visual without a camera", "a camera");
  }
  if (rig.odometry.kind == OdometryRigKind::Scan && !rig.scanner) {
    throwBadInput(source, "odometry.kind", "scan without a scanner", "a scanner");
  }
}

using Json = nlohmann::ordered_json;

/// Degrees that read back as the same radians.
double degreesOf(double radians) {
  const double degrees = toDegrees(radians);
  const double rounded = std::round(degrees * 1e6) / 1e6;
  return toRadians(rounded) == radians ? rounded : degrees;
}

std::string pathText(const fs::path& path, const fs::path& folder) {
  const fs::path relative = path.lexically_relative(folder);
  const bool inside = !relative.empty() && staysInside(relative);
  return (inside ? relative : path).string();
}

Json cameraJson(const CameraRig& camera, const fs::path& folder) {
  Json json;
  if (camera.right.empty()) {
    json["device"] = camera.left;
  } else {
    json["left"] = camera.left;
    json["right"] = camera.right;
  }
  json["calibration"] = pathText(camera.calibration, folder);
  if (camera.width > 0) json["width"] = camera.width;
  if (camera.height > 0) json["height"] = camera.height;
  if (camera.rate_hz > 0.0) json["rate_hz"] = camera.rate_hz;
  if (camera.right_delay_s != 0.0) json["right_delay_ms"] = camera.right_delay_s * 1000.0;
  const CameraMount& mount = camera.mount;
  json["mount"] = {{"x_m", mount.x},
                   {"y_m", mount.y},
                   {"z_m", mount.z},
                   {"pitch_deg", degreesOf(mount.pitch)},
                   {"yaw_deg", degreesOf(mount.yaw)}};
  return json;
}

Json scannerJson(const ScannerRig& scanner) {
  Json json{{"kind", nameOf(scanner.kind, kScanners)}, {"port", scanner.port}};
  if (scanner.isRos()) json["topic"] = scanner.topic;
  const ScannerMount& mount = scanner.mount;
  json["mount"] = {
      {"x_m", mount.x}, {"y_m", mount.y}, {"z_m", mount.z}, {"yaw_deg", degreesOf(mount.yaw)}};
  return json;
}

Json odometryJson(const OdometryRig& odometry) {
  Json json{{"kind", nameOf(odometry.kind, kOdometries)}};
  if (odometry.isMeasured()) json["port"] = odometry.port;
  if (odometry.kind == OdometryRigKind::Ros) json["topic"] = odometry.topic;
  return json;
}

Json stopsJson(const StopRig& stops) {
  Json pans = Json::array();
  for (const double pan : stops.pans) pans.push_back(degreesOf(pan));
  return {{"pans_deg", pans},
          {"standing_s", stops.standing_s},
          {"every_m", stops.every_m},
          {"automatic", stops.automatic}};
}

}  // namespace

bool CameraRig::operator==(const CameraRig& other) const {
  const auto all = [](const CameraRig& c) {
    const CameraMount& m = c.mount;
    return std::tuple(c.left, c.right, c.calibration, m.x, m.y, m.z, m.pitch, m.yaw, c.width,
                      c.height, c.rate_hz, c.right_delay_s);
  };
  return all(*this) == all(other);
}

StopRig sixPans() {
  StopRig stops;
  for (const double pan_deg : {0.0, 60.0, 120.0, 180.0, -120.0, -60.0}) {
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
  if (version > kVersion) {
    throw Error(ErrorCode::BadInput,
                fmt::format("{}: version: found {}, this program reads up to {}", source, version,
                            kVersion),
                "update the program to use this rig");
  }
  onlyKnown(json, {"format", "version", "name", "range_limit_m", "camera", "head", "scanner",
                   "odometry", "stops", "ros", "record"});
  Rig rig;
  rig.name = json.textOr("name", kMaxTextBytes, "");
  readNumber(json, "range_limit_m", 1.0, 200.0, rig.range_limit_m);
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
  if (const auto record = json.find("record")) rig.record = pathFrom(*record, folder);
  checkTogether(rig, source);
  return rig;
}

Rig readRig(const fs::path& path) {
  Rig rig = parseRig(readFile(path, kMaxBytes), path.string(), path.parent_path());
  if (rig.name.empty()) rig.name = path.stem().string();
  return rig;
}

std::string formatRig(const Rig& rig, const fs::path& folder) {
  Json json{{"format", "handmap-rig"}, {"version", kVersion}};
  if (!rig.name.empty()) json["name"] = rig.name;
  json["range_limit_m"] = rig.range_limit_m;
  if (rig.camera) json["camera"] = cameraJson(*rig.camera, folder);
  if (rig.head) json["head"] = {{"port", rig.head->port}};
  if (rig.scanner) json["scanner"] = scannerJson(*rig.scanner);
  json["odometry"] = odometryJson(rig.odometry);
  if (rig.stops) json["stops"] = stopsJson(*rig.stops);
  if (rig.ros_version != 2) json["ros"] = rig.ros_version;
  if (!rig.record.empty()) json["record"] = pathText(rig.record, folder);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace handmap
