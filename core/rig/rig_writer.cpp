#include <cmath>
#include <tuple>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/geometry/pose2.h"
#include "core/rig/rig_names.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

template <typename Kind, std::size_t count>
std::string nameOf(Kind kind, const std::array<std::pair<Kind, const char*>, count>& known) {
  for (const auto& [its, name] : known) {
    if (kind == its) return name;
  }
  throw Error(ErrorCode::RunFailed, phrase("a virtual rig has no file"));
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
  if (camera.kind != CameraKind::Video) json["kind"] = nameOf(camera.kind, kCameras);
  if (camera.right.empty()) {
    json["device"] = camera.left;
  } else {
    json["left"] = camera.left;
    json["right"] = camera.right;
  }
  if (!camera.ros.empty()) json["ros"] = camera.ros;
  if (!camera.calibration.empty()) json["calibration"] = pathText(camera.calibration, folder);
  if (camera.width > 0) json["width"] = camera.width;
  if (camera.height > 0) json["height"] = camera.height;
  if (camera.rate_hz > 0.0) json["rate_hz"] = camera.rate_hz;
  if (camera.right_delay_s != 0.0) json["right_delay_ms"] = camera.right_delay_s * 1000.0;
  if (camera.right_first) json["right_first"] = true;
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
  Json json{{"pans_deg", pans},
            {"standing_s", stops.standing_s},
            {"every_m", stops.every_m},
            {"automatic", stops.automatic}};
  if (!stops.topic.empty()) json["topic"] = stops.topic;
  return json;
}

Json publishJson(const PublishRig& publish) {
  Json json = Json::object();
  if (!publish.ros.empty()) json["ros"] = publish.ros;
  if (!publish.tf) json["tf"] = false;
  if (publish.foxglove > 0) json["foxglove"] = publish.foxglove;
  if (publish.beyond_this_machine) json["beyond_this_machine"] = true;
  if (!publish.origins.empty()) json["origins"] = publish.origins;
  return json;
}

}  // namespace

bool CameraRig::operator==(const CameraRig& other) const {
  const auto all = [](const CameraRig& c) {
    const CameraMount& m = c.mount;
    return std::tuple(c.kind, c.right_first, c.left, c.right, c.ros, c.calibration, m.x, m.y, m.z,
                      m.pitch, m.yaw, c.width, c.height, c.rate_hz, c.right_delay_s);
  };
  return all(*this) == all(other);
}

std::string formatRig(const Rig& rig, const fs::path& folder) {
  Json json{{"format", "handmap-rig"}, {"version", kRigVersion}};
  if (!rig.name.empty()) json["name"] = rig.name;
  json["range_limit_m"] = rig.range_limit_m;
  if (rig.camera) json["camera"] = cameraJson(*rig.camera, folder);
  if (rig.head) json["head"] = {{"port", rig.head->port}};
  if (rig.scanner) json["scanner"] = scannerJson(*rig.scanner);
  json["odometry"] = odometryJson(rig.odometry);
  if (rig.stops) json["stops"] = stopsJson(*rig.stops);
  if (rig.ros_version != 2) json["ros"] = rig.ros_version;
  if (rig.publish != PublishRig{}) json["publish"] = publishJson(rig.publish);
  if (!rig.record.empty()) json["record"] = pathText(rig.record, folder);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace handmap
