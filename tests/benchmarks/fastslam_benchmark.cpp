// The paper's setting, 100 SLAM × 20 swarm particles, beside the same step on a fixed map.
#include <benchmark/benchmark.h>
#include <tbb/task_arena.h>

#include "core/localization/fastslam_psom.h"
#include "core/perception/range_walls.h"
#include "core/simulation/simulated_source.h"

namespace handmap {
namespace {

std::vector<WallPoint> wallsOf(const Observation& observation) {
  return RangeWalls(40.0, {})(*observation.views.front().points, {});
}

void steps(benchmark::State& state, bool refine) {
  const World world = twoRowWorld(1);
  SlamOptions options;
  options.slam_particles = static_cast<int>(state.range(0));
  options.refine = refine;
  tbb::task_arena arena(static_cast<int>(state.range(1)));
  int frames = 0;
  for (auto _ : state) {
    state.PauseTiming();
    const auto source = simulate(world, {}, 1);
    FastSlamPsom slam(perturbed(world.map, 5.0, 1), source->info().start_odometry, options, 1);
    LocalMapBuilder builder(40.0, {});
    std::vector<std::pair<Pose2, LocalMap>> percepts;
    for (int i = 0; i < 8; ++i) {
      const auto observation = source->next();
      percepts.emplace_back(observation->odometry,
                            builder.add(observation->odometry, true, wallsOf(*observation)));
    }
    state.ResumeTiming();
    for (const auto& percept : percepts) {
      arena.execute([&] { slam.step(frames++, percept.first, percept.second); });
    }
  }
  state.counters["ms_per_frame"] =
      benchmark::Counter(frames * 1e-3, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void refining(benchmark::State& state) { steps(state, true); }
void localizing(benchmark::State& state) { steps(state, false); }

BENCHMARK(refining)
    ->ArgsProduct({{100, 1000}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(localizing)
    ->ArgsProduct({{100, 10000}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace handmap
