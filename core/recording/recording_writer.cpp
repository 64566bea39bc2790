#include <cerrno>
#include <chrono>
#include <cstring>
#include <limits>
#include <optional>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/recording/as_written.h"
#include "core/recording/calibration.h"
#include "core/recording/frame_table.h"
#include "core/recording/image_file.h"
#include "core/recording/recording.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

constexpr auto kSyncEvery = std::chrono::milliseconds(900);

/// Its angles are written in degrees.
CameraMount asWritten(CameraMount mount) {
  mount.pitch = toRadians(toDegrees(mount.pitch));
  mount.yaw = toRadians(toDegrees(mount.yaw));
  return mount;
}

/// Programs that read version 1 alone look for a file a frame.
constexpr int kVersionWithParts = 2;
constexpr double kSecondsOfFile = 60.0;

std::string formatRecordingJson(const SourceInfo& info, int version) {
  nlohmann::ordered_json json = {{"format", "handmap-recording"},
                                 {"version", version},
                                 {"name", info.name},
                                 {"range_limit_m", info.range_limit_m}};
  if (info.camera) {
    const CameraMount& mount = info.camera->mount;
    json["camera"] = {{"calibration", "calib.txt"},
                      {"left", "P0"},
                      {"right", "P1"},
                      {"rectified", true},
                      {"mount",
                       {{"x_m", mount.x},
                        {"y_m", mount.y},
                        {"z_m", mount.z},
                        {"pitch_deg", toDegrees(mount.pitch)},
                        {"yaw_deg", toDegrees(mount.yaw)}}}};
  }
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void createEmpty(const fs::path& folder) {
  std::error_code error;
  if (fileExists(folder) && !fs::is_empty(folder, error)) {
    throw Error(ErrorCode::RunFailed, phrase("{}: found a folder that is not empty, "
                                             "expected a new one",
                                             folder.string()));
  }
  fs::create_directories(folder, error);
  if (error) {
    throw Error(ErrorCode::RunFailed,
                phrase("{}: cannot be created: {}", folder.string(), error.message()));
  }
}

}  // namespace

/// A file that grows by whole pieces; they are with the system when append() returns.
class GrowingFile {
 public:
  explicit GrowingFile(fs::path path) : path_(std::move(path)) {}
  ~GrowingFile() {
    if (descriptor_ < 0) return;
    fdatasync(descriptor_);
    close(descriptor_);
  }
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  void append(std::string_view text) {
    if (descriptor_ < 0) {
      descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, kPermissions);
      if (descriptor_ < 0) fail(errno);
    }
    struct stat status {};
    if (fstat(descriptor_, &status) == 0 && status.st_nlink == 0) fail(ENOENT);  // taken away
    const auto whole = static_cast<off_t>(text.size());
    while (!text.empty()) {
      const ssize_t count = write(descriptor_, text.data(), text.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail(errno);
      text.remove_prefix(static_cast<std::size_t>(count));
    }
    written_ += whole;
  }

  off_t written() const { return written_; }
  const fs::path& path() const { return path_; }

  /// On the disk, as far as there is one.
  void sync() const {
    if (descriptor_ < 0 || fdatasync(descriptor_) == 0) return;
    if (errno != EINVAL && errno != ENOTSUP) fail(errno);
  }

 private:
  static constexpr mode_t kPermissions = 0666;  // less the umask

  [[noreturn]] void fail(int reason) const {
    if (descriptor_ >= 0) {  // a full disk leaves no half line
      [[maybe_unused]] const int ignored = ftruncate(descriptor_, written_);
    }
    throw Error(ErrorCode::RunFailed,
                phrase("{}: cannot be written: {}", path_.string(), std::strerror(reason)));
  }

  fs::path path_;
  int descriptor_ = -1;
  off_t written_ = 0;
};

struct RecordingWriter::Files {
  Files(const fs::path& of_folder, SourceInfo its_info)
      : folder(of_folder),
        info(std::move(its_info)),
        frames(folder / "frames.csv"),
        odometry(folder / "odometry.tum"),
        truth(folder / "truth.tum") {}

  /// "image_0/000012.png"
  std::string nameOf(const char* kind, const char* ending, const Observation& observation,
                     std::size_t view) const {
    std::error_code ignored;  // writing into it tells
    fs::create_directory(folder / kind, ignored);
    return fmt::format("{}/{}", kind, fileName(observation, view, ending));
  }

  FrameRow writeView(const Observation& observation, std::size_t index) {
    const View& view = observation.views[index];
    FrameRow row;
    row.frame = observation.frame;
    row.time_s = observation.time_s;
    if (observation.standing || observation.views.size() > 1) row.stop = observation.frame;
    row.pan = view.pan;
    if (!view.left.empty() && !view.right.empty()) {
      row.left = nameOf("image_0", ".png", observation, index);
      row.right = nameOf("image_1", ".png", observation, index);
      writePng(view.left, folder / row.left);
      writePng(view.right, folder / row.right);
    }
    if (view.points) row.points = writePoints(view, observation.time_s);
    return row;
  }

  /// As frames.csv names them. With the system before their row is.
  std::string writePoints(const View& view, double time_s) {
    if (!points) {
      writeFileAtomically(folder / "recording.json", json_with_parts);
      std::error_code ignored;  // writing into it tells
      fs::create_directory(folder / "points", ignored);
      first_points_s = time_s;
    }
    const auto minute = static_cast<long>((time_s - first_points_s) / kSecondsOfFile);
    const std::string name = fmt::format("points/minute-{:04}.bin", minute);
    if (!points || points->path() != folder / name) {
      points.emplace(folder / name);
      ids.reset();
    }
    const off_t offset = points->written();
    const std::size_t bytes = view.points->size() * sizeof(RangePoint);
    writeIds(view);
    points->append({reinterpret_cast<const char*>(view.points->data()), bytes});
    return fmt::format("{}@{}+{}", name, offset, bytes);
  }

  /// Beside the points, from the first that has one on; those before it have none.
  void writeIds(const View& view) {
    if (view.ids.empty() && !ids) return;
    std::vector<std::uint32_t> numbers;
    if (!ids) {
      ids.emplace(fs::path(points->path()).replace_extension(".ids"));
      numbers.resize(static_cast<std::size_t>(points->written()) / sizeof(RangePoint));
    }
    numbers.insert(numbers.end(), view.ids.begin(), view.ids.end());
    if (view.ids.empty()) numbers.resize(numbers.size() + view.points->size());
    ids->append(
        {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(std::uint32_t)});
  }

  /// Points and poses first: a row is never there without its pose.
  void syncNowAndThen() {
    const auto now = std::chrono::steady_clock::now();
    if (now - synced < kSyncEvery) return;
    synced = now;
    if (points) points->sync();
    if (ids) ids->sync();
    odometry.sync();
    truth.sync();
    frames.sync();
  }

  fs::path folder;
  SourceInfo info;
  std::string json_with_parts;  ///< recording.json once there are points
  std::chrono::steady_clock::time_point synced = std::chrono::steady_clock::now();
  GrowingFile frames;
  GrowingFile odometry;
  GrowingFile truth;
  std::optional<GrowingFile> points;
  std::optional<GrowingFile> ids;
  double first_points_s = 0.0;
  int last_frame = -1;
  double last_time_s = -std::numeric_limits<double>::infinity();
};

RecordingWriter::RecordingWriter(const fs::path& folder, const SourceInfo& info) {
  createEmpty(folder);
  files_ = std::make_unique<Files>(folder, info);
  if (info.camera) {
    const fs::path calibration = folder / "calib.txt";
    writeFileAtomically(calibration, formatCalibration(*info.camera));
    files_->info.camera = readCalibration(calibration, "P0", "P1", asWritten(info.camera->mount));
  }
  files_->info.start_odometry = asWritten(info.start_odometry);
  writeFileAtomically(folder / "recording.json", formatRecordingJson(info, 1));
  files_->json_with_parts = formatRecordingJson(info, kVersionWithParts);
  files_->frames.append(frameTableHeader());
}

RecordingWriter::~RecordingWriter() = default;

Observation asReplayed(Observation observation) {
  observation.odometry = asWritten(observation.odometry);
  for (View& view : observation.views) view.pan = toRadians(toDegrees(view.pan));
  return observation;
}

const SourceInfo& RecordingWriter::info() const { return files_->info; }

std::string RecordingWriter::fileName(const Observation& observation, std::size_t view,
                                      const char* ending) {
  const std::string suffix = observation.views.size() > 1 ? fmt::format("-{}", view + 1) : "";
  return fmt::format("{:06}{}{}", observation.frame, suffix, ending);
}

void RecordingWriter::add(const Observation& observation, const std::optional<Pose2>& truth) {
  Files& files = *files_;
  if (observation.frame <= files.last_frame || observation.time_s <= files.last_time_s) {
    throw Error(ErrorCode::RunFailed,
                phrase("{}: found frame {} at {} s after frame {} at {} s, expected both to "
                       "increase",
                       files.folder.string(), observation.frame, observation.time_s,
                       files.last_frame, files.last_time_s));
  }
  files.last_frame = observation.frame;
  files.last_time_s = observation.time_s;
  // Poses first: a row without its pose could not be replayed, a pose without a row does no harm.
  if (!files.info.without_odometry)
    files.odometry.append(formatTum({{observation.time_s, observation.odometry}}));
  if (truth) files.truth.append(formatTum({{observation.time_s, *truth}}));
  for (std::size_t i = 0; i < observation.views.size(); ++i) {
    const FrameRow row = files.writeView(observation, i);
    if (row.left.empty() && row.points.empty()) continue;
    files.frames.append(formatFrameRow(row));
  }
  files.syncNowAndThen();
}

}  // namespace handmap
