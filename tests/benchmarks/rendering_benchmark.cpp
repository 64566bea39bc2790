// Rendered stereo pairs: the scene of a stop, the depth buffer, the whole pair.
#include <benchmark/benchmark.h>

#include "core/rendering/renderer.h"
#include "core/rendering/visibility.h"
#include "core/simulation/route.h"

namespace handmap {
namespace {

const World& street() {
  static const World kWorld = streetWorld(1);
  return kWorld;
}

Pose2 halfWay() {
  const std::optional<Route> route = routeOf(street().map);
  return route->poseAt(route->length() / 2.0);
}

void sceneOfAStop(benchmark::State& state) {
  const Renderer renderer(RenderOptions{}, 1);
  for (auto _ : state) {
    const Scene scene = renderer.sceneAt(street(), halfWay(), 0.0);
    benchmark::DoNotOptimize(scene.model().surfaces.data());
  }
}
BENCHMARK(sceneOfAStop)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void depthBuffer(benchmark::State& state) {
  const RenderOptions options;
  const Renderer renderer(options, 1);
  const Scene scene = renderer.sceneAt(street(), halfWay(), 0.0);
  const ViewCamera camera =
      viewCamera(renderer.camera(), options.width, options.height, halfWay(), 0.0);
  for (auto _ : state) {
    benchmark::DoNotOptimize(visibilityOf(scene.model().surfaces, camera, 2).seen.data());
  }
}
BENCHMARK(depthBuffer)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

/// A pan at a time, all around.
void stereoPair(benchmark::State& state) {
  RenderOptions options;
  options.colour = state.range(0) != 0;
  const Renderer renderer(options, 1);
  const Scene scene = renderer.sceneAt(street(), halfWay(), 0.0);
  std::uint32_t view = 0;
  for (auto _ : state) {
    const double pan = toRadians(60.0 * (view % 6) - 150.0);
    benchmark::DoNotOptimize(renderer.images(scene, halfWay(), pan, 0, view % 6).left.data);
    ++view;
  }
}
BENCHMARK(stereoPair)
    ->ArgName("colour")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace handmap
