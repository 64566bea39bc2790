// Time of a frame: the local map and the step of FastSLAM/PSOM, in the paper's setting of 100 SLAM
// particles × 20 swarm particles × 10 iterations and beyond. p95 and median are over the frames of
// a way; of every frame the quickest of all repetitions counts, since other programs only add.
// x_direct: how much longer the plain form (tests/core/localization/direct_fastslam.h: walls read
// cell by cell, one thread) takes for the same frames. The street needs ../shared/data.
#include <chrono>
#include <filesystem>
#include <limits>

#include <benchmark/benchmark.h>
#include <tbb/task_arena.h>

#include "core/localization/fastslam_psom.h"
#include "core/map/map_io.h"
#include "core/perception/range_walls.h"
#include "core/recording/recording.h"
#include "core/simulation/simulated_source.h"
#include "tests/core/localization/direct_fastslam.h"

namespace handmap {
namespace {

const std::filesystem::path kStreet = std::filesystem::path(HANDMAP_SHARED_DATA) / "street";

struct Frame {
  Pose2 odometry;
  bool standing;
  std::vector<WallPoint> walls;
};

struct Drive {
  Map drawing;
  Pose2 start_odometry;
  std::vector<Frame> frames;
};

Drive driveOf(const Map& drawing, ObservationSource& source) {
  Drive drive{drawing, source.info().start_odometry, {}};
  RangeWalls walls(source.info().range_limit_m, {});
  while (const auto observation = source.next()) {
    drive.frames.push_back({observation->odometry, observation->standing,
                            walls(*observation->views.front().points, observation->odometry)});
  }
  return drive;
}

/// The paper's scene, stops every 5 m, drawn off by 5 m.
const Drive& rows() {
  static const Drive kDrive = [] {
    const World world = twoRowWorld(1);
    return driveOf(perturbed(world.map, 5.0, 1), *simulate(world, {}, 1));
  }();
  return kDrive;
}

/// The same among buildings that are never near.
Drive rowsAmong(int buildings) {
  Drive drive = rows();
  for (int i = static_cast<int>(drive.drawing.buildings.size()); i < buildings; ++i) {
    Building building;
    building.id = "far" + std::to_string(i);
    building.shape = Rectangle{{30.0 * (i % 100) - 1500.0, 300.0 + 20.0 * (i / 100)}, 20, 12, 0};
    drive.drawing.buildings.push_back(building);
  }
  return drive;
}

/// The lidar of the real street, drawn with care.
const Drive& street() {
  static const Drive kDrive = [] {
    ReplayOptions options;
    options.from = 40;
    options.kind = SourceKind::Points;
    return driveOf(readMap(kStreet / "sketch-a.handmap"), *replay(openRecording(kStreet), options));
  }();
  return kDrive;
}

/// Milliseconds of every frame.
using Times = std::vector<double>;

double share(Times times, double of) {
  std::sort(times.begin(), times.end());
  return times[static_cast<std::size_t>(of * static_cast<double>(times.size() - 1))];
}

/// Adds one repetition.
template <typename Slam>
void time(const Drive& drive, Slam& slam, Times& best) {
  best.resize(drive.frames.size(), std::numeric_limits<double>::infinity());
  LocalMapBuilder builder(40.0, {});
  for (std::size_t i = 0; i < drive.frames.size(); ++i) {
    const Frame& frame = drive.frames[i];
    std::vector<WallPoint> walls = frame.walls;
    const auto begin = std::chrono::steady_clock::now();
    const LocalMap map = builder.add(frame.odometry, frame.standing, std::move(walls));
    slam(static_cast<double>(i), frame.odometry, map);
    const std::chrono::duration<double, std::milli> taken =
        std::chrono::steady_clock::now() - begin;
    best[i] = std::min(best[i], taken.count());
  }
}

void timeFast(const Drive& drive, const SlamOptions& options, int threads, Times& best) {
  FastSlamPsom fast(drive.drawing, drive.start_odometry, options, 1);
  tbb::task_arena arena(threads);
  arena.execute([&] {
    const auto step = [&](double time_s, const Pose2& odometry, const LocalMap& map) {
      fast.step(time_s, odometry, map);
    };
    time(drive, step, best);
  });
}

void timeDirect(const Drive& drive, const SlamOptions& options, Times& best) {
  test::DirectFastSlam direct(drive.drawing, drive.start_odometry, options, 1);
  const auto step = [&](double, const Pose2& odometry, const LocalMap& map) {
    direct.step(odometry, map);
  };
  time(drive, step, best);
}

void report(benchmark::State& state, const Times& best) {
  state.counters["median_ms"] = share(best, 0.5);
  state.counters["p95_ms"] = share(best, 0.95);
}

void frames(benchmark::State& state, const Drive& drive, bool refine) {
  SlamOptions options;
  options.slam_particles = static_cast<int>(state.range(0));
  options.refine = refine;
  Times best;
  for (auto _ : state) timeFast(drive, options, static_cast<int>(state.range(1)), best);
  report(state, best);
}

/// Fast and direct by turns, so that what else the machine does meets both.
void beside(benchmark::State& state, const Drive& drive, bool refine) {
  SlamOptions options;
  options.slam_particles = static_cast<int>(state.range(0));
  options.refine = refine;
  Times best;
  Times direct;
  for (auto _ : state) {
    timeFast(drive, options, static_cast<int>(state.range(1)), best);
    timeDirect(drive, options, direct);
  }
  report(state, best);
  state.counters["direct_p95_ms"] = share(direct, 0.95);
  state.counters["x_direct_median"] = share(direct, 0.5) / share(best, 0.5);
  state.counters["x_direct"] = share(direct, 0.95) / share(best, 0.95);
}

bool hasStreet(benchmark::State& state) {
  if (std::filesystem::exists(kStreet)) return true;
  state.SkipWithError("no street recording");
  return false;
}

void paper(benchmark::State& state) { beside(state, rows(), true); }
void paperOnTheStreet(benchmark::State& state) {
  if (hasStreet(state)) beside(state, street(), true);
}
void refining(benchmark::State& state) { frames(state, rows(), true); }
void refiningOnTheStreet(benchmark::State& state) {
  if (hasStreet(state)) frames(state, street(), true);
}
void localizing(benchmark::State& state) { frames(state, rows(), false); }
void localizingOnTheStreet(benchmark::State& state) {
  if (hasStreet(state)) frames(state, street(), false);
}
void refiningAmong(benchmark::State& state) {
  frames(state, rowsAmong(static_cast<int>(state.range(2))), true);
}

void settings(benchmark::internal::Benchmark* it) {
  it->ArgNames({"particles", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK(paper)->Apply(settings)->ArgsProduct({{100}, {1, 2}})->Iterations(5);
BENCHMARK(paperOnTheStreet)->Apply(settings)->ArgsProduct({{100}, {1, 2}})->Iterations(5);
BENCHMARK(refining)->Apply(settings)->ArgsProduct({{100, 1000, 10000}, {1, 2}})->Iterations(3);
BENCHMARK(refiningOnTheStreet)
    ->Apply(settings)
    ->ArgsProduct({{100, 1000, 10000}, {1, 2}})
    ->Iterations(3);
BENCHMARK(refiningAmong)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->ArgNames({"particles", "threads", "buildings"})
    ->ArgsProduct({{100}, {1, 2}, {10, 1000, 10000}})
    ->Iterations(5);
BENCHMARK(localizing)->Apply(settings)->ArgsProduct({{100, 10000}, {1, 2}})->Iterations(10);
BENCHMARK(localizingOnTheStreet)->Apply(settings)->ArgsProduct({{10000}, {1, 2}})->Iterations(10);

}  // namespace
}  // namespace handmap
