// Time of a frame: the local map and the step of FastSLAM/PSOM, in the paper's setting of 100 SLAM
// particles × 20 swarm particles × 10 iterations and beyond. p95 and median are over the frames of
// a way; of every frame the quickest of all repetitions counts, since other programs only add.
// p95_cpu_ms is processor time, of all threads together: what one free core would need.
// x_direct: how much longer the plain form (tests/core/fastslam/direct_fastslam.h: walls read
// cell by cell, one thread) takes for the same frames. The street needs ../shared/data.
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <limits>
#include <thread>

#include <benchmark/benchmark.h>

#include "core/base/parallel.h"
#include "core/fastslam/fastslam_psom.h"
#include "core/map/map_io.h"
#include "core/perception/range_walls.h"
#include "core/recording/recording.h"
#include "core/simulation/simulated_source.h"
#include "tests/core/fastslam/direct_fastslam.h"

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
    building.shape =
        Rectangle{{30.0 * (i % 100) - 1500.0, 300.0 + 20.0 * std::floor(i / 100.0)}, 20, 12, 0};
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

/// Milliseconds of every frame, the least of all repetitions.
struct Times {
  std::vector<double> wall;
  std::vector<double> processor;
};

double processorMs() { return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double share(std::vector<double> times, double of) {
  std::sort(times.begin(), times.end());
  return times[static_cast<std::size_t>(of * static_cast<double>(times.size() - 1))];
}

/// Adds one repetition.
template <typename Slam>
void time(const Drive& drive, Slam& slam, Times& best) {
  best.wall.resize(drive.frames.size(), std::numeric_limits<double>::infinity());
  best.processor.resize(drive.frames.size(), std::numeric_limits<double>::infinity());
  LocalMapBuilder builder(40.0, {});
  for (std::size_t i = 0; i < drive.frames.size(); ++i) {
    const Frame& frame = drive.frames[i];
    std::vector<WallPoint> walls = frame.walls;
    const auto begin = std::chrono::steady_clock::now();
    const double begin_processor = processorMs();
    const LocalMap map = builder.add(frame.odometry, frame.standing, std::move(walls));
    slam(static_cast<double>(i), frame.odometry, map);
    const std::chrono::duration<double, std::milli> taken =
        std::chrono::steady_clock::now() - begin;
    best.wall[i] = std::min(best.wall[i], taken.count());
    best.processor[i] = std::min(best.processor[i], processorMs() - begin_processor);
  }
}

void timeFast(const Drive& drive, const SlamOptions& options, int threads, Times& best) {
  FastSlamPsom fast(drive.drawing, drive.start_odometry, options, 1);
  Arena arena(threads);
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
  state.counters["median_ms"] = share(best.wall, 0.5);
  state.counters["p95_ms"] = share(best.wall, 0.95);
  state.counters["p95_cpu_ms"] = share(best.processor, 0.95);
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
  state.counters["direct_p95_ms"] = share(direct.wall, 0.95);
  state.counters["x_direct_median"] = share(direct.wall, 0.5) / share(best.wall, 0.5);
  state.counters["x_direct"] = share(direct.wall, 0.95) / share(best.wall, 0.95);
}

/// The wall likelihood alone, as much as a frame of the paper's setting can ask for: 100 particles,
/// three buildings of 50 m, 20 members, 11 times, 5 m around the truth: 66,000 buildings.
class Likelihoods {
 public:
  Likelihoods() {
    RandomStream random(2);
    for (const double x : {-30.0, 0.0, 30.0}) {
      Building building;
      building.shape = Rectangle{{x, 25.0}, 50.0, 15.0, 0.0};
      models_.emplace_back(building);
      for (double s = -20.0; s < 20.0; s += 0.05) {
        walls_.push_back({static_cast<float>(x + s), 17.5F, 0.05F, 1.0F});
      }
    }
    for (int i = 0; i < 100; ++i) {
      poses_.push_back({random.normal(), random.normal(), random.normal(0.0, 0.012)});
    }
    // As FastSlamPsom takes them.
    std::sort(poses_.begin(), poses_.end(),
              [](const Pose2& a, const Pose2& b) { return a.heading < b.heading; });
    for (float& value : off_) value = static_cast<float>(random.normal(0.0, 5.0));
  }

  LocalMap localMap() const { return LocalMapBuilder(40.0, {}).add({}, true, walls_); }

  /// `score` of a model, a pose, and the changes of x, y and width.
  template <typename Score>
  float sum(const Score& score) const {
    float sum = 0.0F;
    for (const Pose2& pose : poses_) {
      for (const BuildingModel& model : models_) sum += score(model, pose, off_);
    }
    return sum;
  }

 private:
  std::vector<BuildingModel> models_;
  std::vector<WallPoint> walls_;
  std::vector<Pose2> poses_;
  std::array<float, 3 * 220> off_{};
};

void likelihoods(benchmark::State& state) {
  const Likelihoods all;
  const LocalMap map = all.localMap();
  LineSums sums;
  double fast_ms = std::numeric_limits<double>::infinity();
  double direct_ms = fast_ms;
  const auto timed = [](double& best_ms, const auto& function) {
    const auto begin = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(function());
    const std::chrono::duration<double, std::milli> taken =
        std::chrono::steady_clock::now() - begin;
    best_ms = std::min(best_ms, taken.count());
  };
  for (auto _ : state) {
    timed(fast_ms, [&] {
      sums.reset(map);
      return all.sum([&](const BuildingModel& model, const Pose2& pose, const auto& off) {
        const WallLikelihood walls(model, pose, unitVector(pose.heading), sums);
        const auto width = static_cast<float>(model.drawn().width);
        float sum = 0.0F;
        for (std::size_t i = 0; i < off.size(); i += 3) {
          sum += discounted(walls(off[i], off[i + 1], width + off[i + 2]), EffectiveRatio::ToAll);
        }
        return sum;
      });
    });
    timed(direct_ms, [&] {
      return all.sum([&](const BuildingModel& model, const Pose2& pose, const auto& off) {
        const test::DirectLikelihood walls(model, pose, map);
        const BuildingState& drawn = model.drawn();
        float sum = 0.0F;
        for (std::size_t i = 0; i < off.size(); i += 3) {
          const BuildingState there{drawn.x + static_cast<double>(off[i]),
                                    drawn.y + static_cast<double>(off[i + 1]),
                                    drawn.width + static_cast<double>(off[i + 2])};
          sum += discounted(walls(there), EffectiveRatio::ToAll);
        }
        return sum;
      });
    });
  }
  state.counters["fast_ms"] = fast_ms;
  state.counters["direct_ms"] = direct_ms;
  state.counters["x_direct"] = direct_ms / fast_ms;
}
BENCHMARK(likelihoods)->Unit(benchmark::kMillisecond)->Iterations(20);

/// How long after a request to stop a step of 10,000 particles returns, at worst.
void stopping(benchmark::State& state) {
  SlamOptions options;
  options.slam_particles = 10000;
  const Drive& drive = rows();
  FastSlamPsom slam(drive.drawing, drive.start_odometry, options, 1);
  LocalMapBuilder builder(40.0, {});
  Arena arena(2);
  double worst_ms = 0.0;
  for (auto _ : state) {
    const Frame& frame = drive.frames[1];
    const LocalMap map = builder.add(frame.odometry, true, frame.walls);
    std::stop_source stop;
    std::chrono::steady_clock::time_point asked;
    std::jthread other([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(5 + 10 * (state.iterations() % 5)));
      asked = std::chrono::steady_clock::now();
      stop.request_stop();
    });
    bool done = false;
    arena.execute([&] { done = slam.step(1.0, frame.odometry, map, stop.get_token()); });
    const auto returned = std::chrono::steady_clock::now();
    other.join();
    const std::chrono::duration<double, std::milli> taken = returned - asked;
    if (!done) worst_ms = std::max(worst_ms, taken.count());
  }
  state.counters["worst_ms"] = worst_ms;
}
BENCHMARK(stopping)->Unit(benchmark::kMillisecond)->Iterations(10);

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
