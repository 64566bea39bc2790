#include "core/recording/recording.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/phrase.h"
#include "core/base/spelling.h"
#include "core/base/text.h"
#include "core/recording/calibration.h"
#include "core/recording/frame_table.h"
#include "core/recording/kitti_folder.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

constexpr int kVersion = 2;  // since 2 a row may name a part of a points file
constexpr std::uintmax_t kMaxRecordingBytes = 1u << 20;
constexpr std::size_t kMaxTextBytes = 4096;
constexpr double kMaxMount = 100.0;
constexpr double kMaxAngleDeg = 360.0;

void checkFormat(const JsonValue& json) {
  if (json.at("format").text(kMaxTextBytes) != "handmap-recording") {
    json.at("format").fail("\"handmap-recording\"");
  }
  const auto version = json.at("version").integer(1, INT64_MAX);
  if (version > kVersion) {
    throw Error(ErrorCode::BadInput,
                phrase("{}: version: found {}, this program reads up to {}", json.source(), version,
                       kVersion),
                phrase("update the program to open this recording"));
  }
}

double numberOr(const JsonValue& object, const std::string& key, double limit, double fallback) {
  const auto value = object.find(key);
  return value ? value->number(-limit, limit) : fallback;
}

CameraMount readMount(const JsonValue& json) {
  return {numberOr(json, "x_m", kMaxMount, 0.0), numberOr(json, "y_m", kMaxMount, 0.0),
          numberOr(json, "z_m", kMaxMount, kDefaultCameraHeight),
          toRadians(numberOr(json, "pitch_deg", kMaxAngleDeg, 0.0)),
          toRadians(numberOr(json, "yaw_deg", kMaxAngleDeg, 0.0))};
}

/// Whether the images on disk still have to be rectified. A calibration of OpenCV says so, too.
bool isUnrectified(const JsonValue& camera, const fs::path& calibration) {
  const std::string ending = calibration.extension().string();
  const bool by_opencv = ending == ".yaml" || ending == ".yml" || ending == ".xml";
  const auto rectified = camera.find("rectified");
  if (!rectified) return by_opencv;
  if (rectified->flag() == by_opencv) {
    camera.at("calibration")
        .fail(by_opencv
                  ? phrase("that of rectified images, as KITTI writes it (\"rectified\" is true)")
                  : phrase("a .yml, .yaml or .xml of OpenCV (\"rectified\" is false)"));
  }
  return by_opencv;
}

/// Fills in camera and rectifier.
void readCamera(const JsonValue& json, Recording& recording) {
  const fs::path calibration = json.textOr("calibration", kMaxTextBytes, "calib.txt");
  if (!staysInside(calibration)) json.at("calibration").fail(phrase("a path inside the folder"));
  CameraMount mount;
  mount.z = kDefaultCameraHeight;
  if (const auto given = json.find("mount")) mount = readMount(*given);
  const fs::path path = recording.folder / calibration;
  if (isUnrectified(json, calibration)) {
    recording.rectifier =
        std::make_shared<const Rectifier>(readStereoCalibration(path), path.string());
    recording.camera = recording.rectifier->camera(mount);
  } else {
    recording.camera = readCalibration(path, json.textOr("left", kMaxTextBytes, "P0"),
                                       json.textOr("right", kMaxTextBytes, "P1"), mount);
  }
}

/// Members that nobody knows but that look like one that is known and not there.
void findStrangeKeys(const JsonValue& object, const std::vector<std::string_view>& known,
                     const std::vector<std::string_view>& free, Recording& recording) {
  std::vector<std::string_view> all = known;
  all.insert(all.end(), free.begin(), free.end());
  for (const auto& [key, value] : object.others(all)) {
    const auto meant = likelyMeant(key, known);
    if (!meant || object.find(*meant)) continue;
    const std::string path = object.path().empty() ? key : object.path() + "." + key;
    recording.strange_keys.push_back(phrase("{}: {}: found a key that nothing knows, expected {}",
                                            object.source(), path, *meant));
  }
}

void findStrangeKeys(const JsonValue& json, Recording& recording) {
  findStrangeKeys(json, {"name", "range_limit_m", "camera"},
                  {"format", "version", "licence", "license"}, recording);
  const auto camera = json.find("camera");
  if (!camera) return;
  findStrangeKeys(*camera, {"calibration", "left", "right", "rectified", "mount"}, {}, recording);
  if (const auto mount = camera->find("mount")) {
    findStrangeKeys(*mount, {"x_m", "y_m", "z_m", "pitch_deg", "yaw_deg"}, {}, recording);
  }
}

Recording openHandmapFolder(const fs::path& folder, const std::stop_token& stop) {
  const fs::path path = folder / "recording.json";
  const auto parsed = parseJson(readFile(path, kMaxRecordingBytes), path.string());
  const JsonValue json(parsed, path.string());
  checkFormat(json);

  Recording recording;
  recording.folder = folder;
  recording.name = json.textOr("name", kMaxTextBytes, "");
  if (const auto range = json.find("range_limit_m")) {
    recording.range_limit_m = range->number(kLeastReach_m, kMostReach_m);
  }
  findStrangeKeys(json, recording);
  recording.rows = readFrameTable(folder / "frames.csv", stop);
  const bool has_images = std::any_of(recording.rows.begin(), recording.rows.end(),
                                      [](const FrameRow& row) { return !row.left.empty(); });
  if (const auto camera = json.find("camera")) {
    readCamera(*camera, recording);
  } else if (has_images) {
    const auto defaults = nlohmann::json::object();
    readCamera(JsonValue(defaults, path.string()), recording);
  }
  if (fileExists(folder / "odometry.tum"))
    recording.odometry = readTum(folder / "odometry.tum", stop);
  if (fileExists(folder / "truth.tum")) recording.truth = readTum(folder / "truth.tum", stop);
  return recording;
}

}  // namespace

Recording openRecording(const fs::path& folder, const std::stop_token& stop) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    throwBadInput(folder.string(), "", phrase("no such folder"),
                  phrase("the folder of a recording"));
  }
  const bool is_handmap = fileExists(folder / "recording.json");
  if (!is_handmap && !isKittiFolder(folder)) {
    throwBadInput(folder.string(), "", phrase("neither recording.json nor a KITTI sequence"),
                  phrase("recording.json, or times.txt and image_0 or image_2"));
  }
  Recording recording =
      is_handmap ? openHandmapFolder(folder, stop) : openKittiFolder(folder, stop);
  if (recording.name.empty()) {
    recording.name = fs::weakly_canonical(folder, error).filename().string();
  }
  return recording;
}

}  // namespace handmap
