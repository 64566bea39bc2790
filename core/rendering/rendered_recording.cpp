#include "core/rendering/rendered_recording.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/recording/recording.h"

namespace handmap {

namespace fs = std::filesystem;

bool renderOnce(const RenderedDrive& drive, const fs::path& folder, const std::stop_token& stop,
                const std::function<void(double)>& progress) {
  if (fileExists(folder)) return true;
  const fs::path unfinished = folder.string() + ".part";
  std::error_code error;
  fs::remove_all(unfinished, error);
  const auto source =
      renderedSource(drive.world, drive.simulation, drive.rendering, drive.looking, drive.seed);
  RecordingWriter writer(unfinished, source->info());
  const auto& truth = source->info().truth;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (stop.stop_requested()) return false;
    progress(static_cast<double>(i) / static_cast<double>(truth.size()));
    writer.add(source->next().value(), truth[i].pose);
  }
  fs::rename(unfinished, folder, error);
  if (error) {
    throw Error(ErrorCode::RunFailed,
                fmt::format("{}: cannot be written: {}", folder.string(), error.message()));
  }
  return true;
}

}  // namespace handmap
