#include "core/recording/kitti_folder.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/recording/calibration.h"
#include "core/recording/frame_table.h"
#include "core/recording/time_limits.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kMaxKittiBytes = 256u << 20;
constexpr double kMaxCoordinate = 1e8;
constexpr double kRotationTolerance = 0.01;

Pose2 parsePose(const TextLine& line, const std::string& file) {
  const std::string place = phrase("line {}", line.number);
  const auto words = splitWords(line.text);
  if (words.size() != 12) {
    throwBadInput(file, place, phrase("{} numbers", words.size()), "12");
  }
  Eigen::Matrix<double, 3, 4, Eigen::RowMajor> pose;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto value = parseFinite(words[i]);
    if (!value || std::abs(*value) > kMaxCoordinate) {
      throwBadInput(file, place, fmt::format("\"{}\"", words[i].substr(0, 40)),
                    phrase("a finite number"));
    }
    pose.data()[i] = *value;
  }
  const Eigen::Matrix3d rotation = pose.leftCols<3>();
  const bool is_rotation =
      (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm() < kRotationTolerance &&
      rotation.determinant() > 0.0;
  if (!is_rotation) {
    throwBadInput(file, place, phrase("no rotation matrix"), phrase("an orthonormal one"));
  }
  return {pose(2, 3), -pose(0, 3), std::atan2(-rotation(0, 2), rotation(2, 2))};
}

/// The names of the images of a camera: as many digits and the ending as the first one found has.
struct ImageNames {
  std::string camera;  ///< "image_0"
  std::size_t digits = 6;
  std::string ending = ".png";

  std::string name(std::size_t frame) const {
    return fmt::format("{}/{:0{}}{}", camera, frame, digits, ending);
  }
};

ImageNames imageNames(const fs::path& folder, const std::string& camera) {
  ImageNames names{camera};
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder / camera, error)) {
    const std::string ending = entry.path().extension().string();
    const std::string stem = entry.path().stem().string();
    const bool is_number = stem.size() <= 20 && parseInteger(stem).has_value();
    if (!is_number || (ending != ".png" && ending != ".jpg" && ending != ".jpeg")) continue;
    names.digits = stem.size();
    names.ending = ending;
    return names;
  }
  throwBadInput((folder / camera).string(), "", phrase("no images"),
                phrase("000000.png or .jpg and so on"));
}

std::optional<fs::path> firstExisting(const fs::path& folder,
                                      const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (fileExists(folder / name)) return folder / name;
  }
  return std::nullopt;
}

std::optional<fs::path> odometryFile(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("odometry") && name.ends_with("_kitti.txt")) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  names.insert(names.begin(), "odometry.tum");
  return firstExisting(folder, names);
}

}  // namespace

std::vector<double> readKittiTimes(const fs::path& path) {
  const std::string file = path.string();
  const std::string content = readFile(path, kMaxKittiBytes);
  std::vector<double> times;
  ContentLines lines(content);
  while (const auto line = lines.next()) {
    const std::string place = phrase("line {}", line->number);
    const auto time = parseFinite(line->text);
    if (!time || std::abs(*time) > kMaxTime_s) {
      throwBadInput(file, place, fmt::format("\"{}\"", line->text.substr(0, 40)),
                    phrase("a time in seconds"));
    }
    if (!times.empty() && *time <= times.back()) {
      throwBadInput(file, place,
                    phrase("time {} after {}", formatNumber(*time), formatNumber(times.back())),
                    phrase("times that increase"));
    }
    if (times.size() == kMaxRows)
      throwBadInput(file, place, phrase("one more time"), phrase("at most {}", kMaxRows));
    times.push_back(*time);
  }
  if (times.empty()) throwBadInput(file, "", phrase("no time"), phrase("one a line"));
  return times;
}

Trajectory readKittiPoses(const fs::path& path, const std::vector<double>& times_s) {
  const std::string file = path.string();
  const std::string content = readFile(path, kMaxKittiBytes);
  std::vector<StampedPose> poses;
  std::size_t found = 0;
  ContentLines lines(content);
  while (const auto line = lines.next()) {
    if (found < times_s.size()) poses.push_back({times_s[found], parsePose(*line, file)});
    ++found;
  }
  if (found != times_s.size()) {
    throwBadInput(file, "", phrase("{} poses", found),
                  phrase("{}, one for each line of times.txt", times_s.size()));
  }
  const Pose2 first = poses.empty() ? Pose2{} : poses.front().pose;
  for (StampedPose& stamped : poses) stamped.pose = between(first, stamped.pose);
  return {std::move(poses), file};
}

bool isKittiFolder(const fs::path& folder) {
  return fileExists(folder / "times.txt") &&
         (fileExists(folder / "image_0") || fileExists(folder / "image_2"));
}

Recording openKittiFolder(const fs::path& folder, const std::stop_token& stop) {
  const bool is_grey = fileExists(folder / "image_0");
  const ImageNames left = imageNames(folder, is_grey ? "image_0" : "image_2");
  const ImageNames right = imageNames(folder, is_grey ? "image_1" : "image_3");
  CameraMount mount;
  mount.z = kDefaultCameraHeight;

  Recording recording;
  recording.folder = folder;
  recording.camera =
      readCalibration(folder / "calib.txt", is_grey ? "P0" : "P2", is_grey ? "P1" : "P3", mount);
  const std::vector<double> times = readKittiTimes(folder / "times.txt");
  for (std::size_t i = 0; i < times.size(); ++i) {
    throwIfStopped(stop);
    FrameRow row;
    row.frame = static_cast<int>(i);
    row.time_s = times[i];
    row.left = left.name(i);
    row.right = right.name(i);
    recording.rows.push_back(std::move(row));
  }
  if (const auto path = firstExisting(folder, {"poses.txt", "poses_gt_kitti.txt"})) {
    recording.truth = readKittiPoses(*path, times);
  }
  if (const auto path = odometryFile(folder)) {
    recording.odometry =
        path->extension() == ".tum" ? readTum(*path, stop) : readKittiPoses(*path, times);
  }
  return recording;
}

}  // namespace handmap
