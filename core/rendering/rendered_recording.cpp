#include "core/rendering/rendered_recording.h"

#include <chrono>
#include <cstdlib>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/recording/as_written.h"
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
      throw Error(ErrorCode::RunFailed, phrase("{}: the folder cannot be made", name));
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
                  phrase("{}: cannot be written: {}", folder_.string(), error.message()));
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

/// Hands out what it renders, and keeps it.
class KeptSource : public ObservationSource {
 public:
  KeptSource(std::unique_ptr<ObservationSource> source, const fs::path& folder)
      : source_(std::move(source)), info_(source_->info()) {
    keeping([&] {
      kept_.emplace(folder, info_);
      info_ = kept_->writer.info();
    });
  }

  const SourceInfo& info() const override { return info_; }

  std::optional<Observation> next() override {
    auto observation = source_->next();
    if (!observation) return std::nullopt;
    observation = asReplayed(std::move(*observation));
    if (kept_) keeping([&] { keep(*observation); });
    return observation;
  }

 private:
  struct Kept {
    Kept(const fs::path& place, const SourceInfo& info)
        : folder(place), writer(folder.path(), info) {}
    Unfinished folder;
    RecordingWriter writer;
    std::size_t count = 0;
  };

  void keep(const Observation& observation) {
    kept_->writer.add(observation, info_.truth[kept_->count].pose);
    if (++kept_->count < info_.truth.size()) return;
    kept_->folder.moveToItsPlace();
    kept_.reset();
  }

  template <typename Work>
  void keeping(Work work) {
    try {
      work();
    } catch (const Error&) {
      kept_.reset();
    }
  }

  std::unique_ptr<ObservationSource> source_;
  SourceInfo info_;
  std::optional<Kept> kept_;  ///< while it can be
};

}  // namespace

std::unique_ptr<ObservationSource> renderedOnce(const RenderedDrive& drive, const fs::path& folder,
                                                const std::stop_token& stop) {
  if (fileExists(folder)) return replay(openRecording(folder, stop), {});
  return std::make_unique<KeptSource>(renderedSource(drive.world, drive.simulation, drive.rendering,
                                                     drive.looking, drive.seed, {}, stop),
                                      folder);
}

}  // namespace handmap
