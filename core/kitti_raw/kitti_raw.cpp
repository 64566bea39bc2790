#include "core/kitti_raw/kitti_raw.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/kitti_raw/kitti_files.h"
#include "core/recording/image_file.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

constexpr double kCameraHeight_m = 1.65;  // of KITTI's car
constexpr double kEarth_m = 6378137.0;
constexpr double kSees_m = 80.0;
constexpr std::size_t kStride = 4;

fs::path calibrationFile(const fs::path& folder, const std::string& name) {
  for (const fs::path& at : {folder / name, folder.parent_path() / name}) {
    if (fs::is_regular_file(at)) return at;
  }
  throwBadInput((folder / name).string(), "", phrase("no such file, nor in the folder above"),
                phrase("the calibration of that day beside the drive"));
}

/// data/0000000012.png of a sensor's folder; empty where there is none.
fs::path fileOf(const fs::path& sensor, std::size_t number, const char* ending) {
  const fs::path file = sensor / "data" / fmt::format("{:010}{}", number, ending);
  return fs::is_regular_file(file) ? file : fs::path();
}

class Drive {
 public:
  Drive(fs::path folder, std::vector<std::string>& notes)
      : folder_(std::move(folder)), notes_(notes) {
    const bool has_images = fs::exists(left() / "timestamps.txt") && fs::exists(right());
    if (fs::exists(velodyne() / "timestamps.txt")) {
      scan_times_ = readKittiTimestamps(velodyne() / "timestamps.txt");
    }
    if (has_images) times_ = readKittiTimestamps(left() / "timestamps.txt");
    if (times_.empty()) times_ = scan_times_;
    if (!scan_times_.empty() || has_images) readCalibrations(has_images);
  }

  SourceInfo info(const std::string& name) const {
    SourceInfo info;
    info.without_odometry = true;
    info.name = name;
    info.range_limit_m = kSees_m;
    info.camera = camera_;
    return info;
  }
  std::size_t rows() const { return times_.size(); }

  Observation row(std::size_t i) const {
    Observation observation;
    observation.frame = static_cast<int>(i);
    observation.time_s = times_[i];
    View view;
    const fs::path left_file = camera_ ? fileOf(left(), i, ".png") : fs::path();
    const fs::path right_file = camera_ ? fileOf(right(), i, ".png") : fs::path();
    if (!left_file.empty() && !right_file.empty()) {
      view.left = readImage(left_file);
      view.right = readImage(right_file);
    }
    const fs::path scan = scan_times_.empty() ? fs::path() : fileOf(velodyne(), i, ".bin");
    if (!scan.empty()) {
      std::vector<RangePoint> points = readKittiScan(scan, kStride);
      const Eigen::Isometry3f pose = scanner_.cast<float>();
      for (RangePoint& p : points) {
        const Eigen::Vector3f at = pose * Eigen::Vector3f(p.x, p.y, p.z);
        p = {at.x(), at.y(), at.z(), p.w};
      }
      view.points = std::move(points);
    }
    observation.views.push_back(std::move(view));
    return observation;
  }

  /// nullopt where no fix is there.
  std::optional<Pose2> truth(std::size_t i) {
    const fs::path file = fileOf(folder_ / "oxts", i, ".txt");
    if (file.empty()) return std::nullopt;
    const KittiFix fix = readKittiFix(file);
    if (!first_) first_ = fix;
    const double scale = kEarth_m * std::cos(toRadians(first_->latitude));
    const auto north = [](double latitude) {
      return std::log(std::tan(0.25 * kPi + 0.5 * toRadians(latitude)));
    };
    const Pose2 unit{scale * toRadians(fix.longitude - first_->longitude),
                     scale * (north(fix.latitude) - north(first_->latitude)), fix.heading};
    return unit * Pose2{camera_at_.x(), camera_at_.y(), 0.0};
  }

 private:
  fs::path left() const { return folder_ / "image_00"; }
  fs::path right() const { return folder_ / "image_01"; }
  fs::path velodyne() const { return folder_ / "velodyne_points"; }

  void readCalibrations(bool has_images) {
    const KittiCalibration cameras(calibrationFile(folder_, "calib_cam_to_cam.txt"));
    const auto& rotation = cameras.numbers("R_rect_00", 9);
    Eigen::Isometry3d rectified = Eigen::Isometry3d::Identity();
    rectified.linear() =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rotation.data());
    if (has_images) {
      const auto& p = cameras.numbers("P_rect_00", 12);
      const auto& q = cameras.numbers("P_rect_01", 12);
      const double baseline_m = p[0] > 0.0 ? (p[3] - q[3]) / p[0] : 0.0;
      if (!(baseline_m > 0.0 && baseline_m < 10.0 && p[5] > 0.0)) {
        throwBadInput(calibrationFile(folder_, "calib_cam_to_cam.txt").string(), "P_rect_01",
                      phrase("a baseline of {:.3g} m", baseline_m),
                      phrase("the right camera to the right"));
      }
      camera_ = StereoCamera{p[0], p[5], p[2], p[6], baseline_m, {}};
      camera_->mount.z = kCameraHeight_m;
    }
    const Eigen::Isometry3d scanner =
        rectified * KittiCalibration(calibrationFile(folder_, "calib_velo_to_cam.txt")).transform();
    Eigen::Isometry3d robot = Eigen::Isometry3d::Identity();  // of the camera: z ahead, y down
    robot.linear() << 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0;
    robot.translation().z() = kCameraHeight_m;
    scanner_ = robot * scanner;
    if (!fs::exists(folder_ / "oxts")) return;
    try {
      const auto unit = KittiCalibration(calibrationFile(folder_, "calib_imu_to_velo.txt"));
      const Eigen::Isometry3d camera = (scanner * unit.transform()).inverse();
      camera_at_ = camera.translation().head<2>();
    } catch (const Error& error) {
      notes_.emplace_back(error.what());
      notes_.push_back(phrase("the true way is that of the inertial unit, not of the camera"));
    }
  }

  fs::path folder_;
  std::vector<std::string>& notes_;
  std::vector<double> times_;
  std::vector<double> scan_times_;
  std::optional<StereoCamera> camera_;
  Eigen::Isometry3d scanner_ = Eigen::Isometry3d::Identity();  ///< in the robot's frame
  Vec2 camera_at_ = Vec2::Zero();                              ///< seen from the inertial unit
  std::optional<KittiFix> first_;
};

}  // namespace

bool isKittiRaw(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / "image_00" / "timestamps.txt", error) ||
         fs::is_regular_file(folder / "velodyne_points" / "timestamps.txt", error);
}

ImportedDrive importKittiRaw(const fs::path& folder, const fs::path& out, const std::string& name,
                             std::vector<std::string>& notes,
                             const std::function<void(double)>& progress,
                             const std::stop_token& stop) {
  if (folder.filename().string().ends_with("_extract")) {
    throwBadInput(folder.string(), "", phrase("a drive that is not rectified"),
                  phrase("the synchronized and rectified one, …_sync"));
  }
  Drive drive(folder, notes);
  RecordingWriter writer(out, drive.info(name));
  ImportedDrive imported;
  for (std::size_t i = 0; i < drive.rows(); ++i) {
    throwIfStopped(stop);
    const Observation observation = drive.row(i);
    const View& view = observation.views.front();
    if (view.left.empty() && !view.points) continue;
    const auto truth = drive.truth(i);
    writer.add(observation, truth);
    imported.pairs += view.left.empty() ? 0 : 1;
    imported.scans += view.points ? 1 : 0;
    imported.poses += truth ? 1 : 0;
    if (progress) progress(static_cast<double>(i + 1) / static_cast<double>(drive.rows()));
  }
  if (imported.pairs + imported.scans == 0) {
    throwBadInput(folder.string(), "", phrase("neither pairs of images nor scans"),
                  "image_00/data/0000000000.png …");
  }
  notes.push_back(imported.pairs > 0 ? phrase("no odometry: the images are to tell the motion")
                                     : phrase("no poses: the scans are to tell the motion"));
  return imported;
}

}  // namespace handmap
