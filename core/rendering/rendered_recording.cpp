#include "core/rendering/rendered_recording.h"

#include <chrono>
#include <cstdlib>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/recording/recording.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

constexpr auto kAbandoned = std::chrono::hours(1);

/// A folder of this call's own beside `folder`: others may be rendering the same. Goes with this
/// object unless it was moved to its place.
class Unfinished {
 public:
  explicit Unfinished(const fs::path& folder) : folder_(folder) {
    std::error_code error;
    fs::create_directories(folder.parent_path(), error);
    removeAbandoned();
    std::string name = prefix() + "XXXXXX";
    if (mkdtemp(name.data()) == nullptr) {
      throw Error(ErrorCode::RunFailed, name + ": the folder cannot be made");
    }
    path_ = name;
  }
  ~Unfinished() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;

  const fs::path& path() const { return path_; }
  void moveToItsPlace() const {
    std::error_code error;
    fs::rename(path_, folder_, error);
    if (error && !fileExists(folder_)) {  // somebody else may have been faster
      throw Error(ErrorCode::RunFailed,
                  fmt::format("{}: cannot be written: {}", folder_.string(), error.message()));
    }
  }

 private:
  std::string prefix() const { return folder_.string() + ".part-"; }
  /// What a program that was killed has left.
  void removeAbandoned() const {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder_.parent_path(), error)) {
      const auto written = entry.last_write_time(error);
      if (!error && entry.path().string().starts_with(prefix()) &&
          fs::file_time_type::clock::now() - written > kAbandoned) {
        fs::remove_all(entry.path(), error);
      }
    }
  }

  fs::path folder_;
  fs::path path_;
};

}  // namespace

bool renderOnce(const RenderedDrive& drive, const fs::path& folder, const std::stop_token& stop,
                const std::function<void(double)>& progress) {
  if (fileExists(folder)) return true;
  const Unfinished unfinished(folder);
  const auto source = renderedSource(drive.world, drive.simulation, drive.rendering, drive.looking,
                                     drive.seed, {}, stop);
  RecordingWriter writer(unfinished.path(), source->info());
  const auto& truth = source->info().truth;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    progress(static_cast<double>(i) / static_cast<double>(truth.size()));
    const auto observation = source->next();
    if (!observation) return false;
    writer.add(*observation, truth[i].pose);
  }
  unfinished.moveToItsPlace();
  return true;
}

}  // namespace handmap
