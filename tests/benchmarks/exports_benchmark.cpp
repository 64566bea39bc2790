// What a run of the street costs as MCAP, page and film: milliseconds and megabytes a frame, beside
// packing its pictures alone.
#include <filesystem>

#include <benchmark/benchmark.h>
#include <opencv2/imgcodecs.hpp>

#include "core/base/text.h"
#include "core/map/map_io.h"
#include "core/recording/recording.h"
#include "core/report/report.h"
#include "core/run_log/run_film.h"
#include "core/run_log/run_log.h"
#include "core/session/run_session.h"

namespace handmap {
namespace {

namespace fs = std::filesystem;

const fs::path kStreet = fs::path(HANDMAP_SHARED_DATA) / "street";

/// Done once for each kind of observation.
struct Driven {
  Recording recording;
  Map drawing;
  SourceInfo source;
  std::vector<std::shared_ptr<const Snapshot>> snapshots;
  std::unique_ptr<RunSession> session;
  std::vector<cv::Mat> images;  ///< that MCAP holds

  explicit Driven(SourceKind kind)
      : recording(openRecording(kStreet)), drawing(readMap(kStreet / "sketch-a.handmap")) {
    ReplayOptions options;
    options.from = 40;
    options.kind = kind;
    options.every = kind == SourceKind::Images ? 4 : 1;  // all of them stay in memory
    session = std::make_unique<RunSession>(drawing, replay(recording, options), RunSettings{});
    source = session->source();
    int pictured = -1;
    while (const auto snapshot = session->step()) {
      snapshots.push_back(snapshot);
      if (snapshot->image.empty() || snapshot->pictured == pictured) continue;
      pictured = snapshot->pictured;
      images.push_back(snapshot->image);
    }
  }
};

const Driven& driven(const benchmark::State& state) {
  static const Driven images(SourceKind::Images);
  static const Driven points(SourceKind::Points);
  return state.range(0) == 0 ? images : points;
}

fs::path out(const char* name) {
  return fs::temp_directory_path() / ("handmap-exports-" + std::string(name));
}

void count(benchmark::State& state, double bytes, const Driven& run) {
  const auto frames = static_cast<double>(run.snapshots.size());
  state.counters["frames"] = frames;
  state.counters["kB_frame"] = bytes / 1e3 / frames;
  state.counters["ms_frame"] = benchmark::Counter(
      1e-3 * frames, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <typename Write>
void written(benchmark::State& state, const char* name, const Write& write) {
  if (!fs::exists(kStreet)) return state.SkipWithError("needs the street");
  const Driven& run = driven(state);
  const fs::path path = out(name);
  for (auto _ : state) {
    fs::remove(path);
    write(path, run);
  }
  count(state, static_cast<double>(fs::file_size(path)), run);
  fs::remove(path);
}

void picturesAlone(benchmark::State& state) {
  if (!fs::exists(kStreet)) return state.SkipWithError("needs the street");
  const Driven& run = driven(state);
  double bytes = 0.0;
  for (auto _ : state) {
    bytes = 0.0;
    for (const cv::Mat& image : run.images) {
      std::vector<unsigned char> packed;
      cv::imencode(".jpg", image, packed, {cv::IMWRITE_JPEG_QUALITY, 80});
      bytes += static_cast<double>(packed.size());
    }
  }
  count(state, bytes, run);
}

void mcap(benchmark::State& state) {
  written(state, "run.mcap", [](const fs::path& path, const Driven& run) {
    RunLog log(path, run.drawing, run.source);
    for (const auto& snapshot : run.snapshots) log.add(*snapshot);
    log.finish(run.session->refinedMap(), run.session->trajectory(), run.session->warnings());
  });
}

void film(benchmark::State& state) {
  written(state, "run.mp4", [](const fs::path& path, const Driven& run) {
    RunFilm film(path, run.drawing);
    for (const auto& snapshot : run.snapshots) film.add(*snapshot);
    film.finish();
  });
}

void page(benchmark::State& state) {
  written(state, "run.html", [](const fs::path& path, const Driven& run) {
    ReportInputs inputs;
    inputs.drawing = run.drawing;
    inputs.refined = run.session->refinedMap();
    inputs.run = run.session->reportJson();
    inputs.run_file = "report.json";
    inputs.trajectory = run.session->trajectory();
    inputs.recording = run.recording;
    writeFileAtomically(path, reportHtml(inputs));
  });
}

// 0: images, 1: lidar.
BENCHMARK(picturesAlone)->Arg(0)->Unit(benchmark::kMillisecond);
BENCHMARK(mcap)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(film)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(page)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace handmap
