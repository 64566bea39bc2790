// A drawn house looked for among what a drive past it saw, beside telling what the rays are from.
#include <benchmark/benchmark.h>

#include "core/outlines/joint_places.h"
#include "tests/core/outlines/drive.h"

namespace handmap {
namespace {

constexpr double kLimit_m = 40.0;
const Polygon kHouse = Rectangle{{20.0, 12.0}, 14.0, 8.0, 0.0}.corners();

const Drive& drive() {
  static const Drive kDrive = drivePast({kHouse, Rectangle{{45.0, 14.0}, 10.0, 8.0, 0.0}.corners(),
                                         Rectangle{{30.0, -11.0}, 20.0, 8.0, 0.0}.corners()});
  return kDrive;
}

void structureOfADrive(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(placeRays(drive().seen, drive().way));
}
BENCHMARK(structureOfADrive)->Unit(benchmark::kMillisecond);

void searchOfAHouse(benchmark::State& state) {
  const PlacedRays placed = placeRays(drive().seen, drive().way);
  OutlinePrior prior;
  prior.start = moved(kHouse, {3.0, -2.0});
  const OutlineScorer scorer = scorerFor(prior, placed, kLimit_m, {}, 0);
  double off = 0.0;
  for (auto _ : state) {
    const auto found = searchOutlines(prior, scorer, RandomStream(1));
    off = (centroid(found.front().outline) - centroid(kHouse)).norm();
  }
  state.counters["off_m"] = off;
}
BENCHMARK(searchOfAHouse)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace handmap
