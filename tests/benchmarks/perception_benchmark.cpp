// Stereo beside cv::StereoSGBM alone on the same images; the local map; the lidar filter.
#include <benchmark/benchmark.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/random.h"
#include "core/perception/perception.h"
#include "core/rendering/rendered_source.h"
#include "tests/core/perception/rendered_scene.h"

namespace handmap {
namespace {

constexpr double kRange_m = 40.0;

const test::StereoPair& street() {
  static const test::StereoPair kPair = test::render({{{{{6, 7}, {30, 7}}, 8.0},
                                                       {{{4, -6}, {25, -6}}, 8.0},
                                                       {{{8, 3}, {12, 3}}, 1.5},
                                                       {{{40, -20}, {40, 20}}, 9.0}},
                                                      0.0},
                                                     test::streetCamera());
  return kPair;
}

void stereoWalls(benchmark::State& state) {
  StereoOptions options;
  options.scale = 1.0 / static_cast<double>(state.range(0));
  StereoWalls stereo(test::streetCamera(), options);
  double rest_ms = 0.0;
  for (auto _ : state) {
    const StereoResult result = stereo(street().left, street().right, 0.0, kRange_m);
    rest_ms += result.walls_ms;
    benchmark::DoNotOptimize(result.walls.data());
  }
  state.counters["after_matching_ms"] =
      benchmark::Counter(rest_ms, benchmark::Counter::kAvgIterations);
}
BENCHMARK(stereoWalls)
    ->Arg(2)
    ->Arg(1)
    ->ArgName("reduced_by")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

/// The same mode, disparities and block, without reducing, padding and walls.
void sgbmAlone(benchmark::State& state) {
  const double scale = 1.0 / static_cast<double>(state.range(0));
  cv::Mat left;
  cv::Mat right;
  cv::resize(street().left, left, {}, scale, scale, cv::INTER_AREA);
  cv::resize(street().right, right, {}, scale, scale, cv::INTER_AREA);
  const int disparities = 128 / static_cast<int>(state.range(0));
  const auto sgbm = cv::StereoSGBM::create(0, disparities, 7, 8 * 49, 32 * 49, 1, 31, 10, 100, 1,
                                           cv::StereoSGBM::MODE_SGBM_3WAY);
  cv::Mat disparity;
  for (auto _ : state) sgbm->compute(left, right, disparity);
}
BENCHMARK(sgbmAlone)
    ->Arg(2)
    ->Arg(1)
    ->ArgName("reduced_by")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

const Observation& panorama(StereoCamera& camera) {
  static const World kWorld = furnished(twoRowWorld(1), 1);
  static const auto kSource = renderedSource(kWorld, {}, {}, Looking::Around, 1);
  static const Observation kObservation = kSource->next().value();
  camera = kSource->info().camera.value();
  return kObservation;
}

/// Six pairs of 640×480 from images to local map and scan, on one thread.
void panoramaToLocalMap(benchmark::State& state) {
  cv::setNumThreads(1);
  SourceInfo source;
  source.camera.emplace();
  const Observation& observation = panorama(*source.camera);
  Perception perception(source, {});
  double stereo_ms = 0.0;
  double all_ms = 0.0;
  for (auto _ : state) {
    const auto percept = perception(observation);
    stereo_ms += percept->stereo_ms;
    all_ms += percept->stereo_ms + percept->classify_ms;
  }
  state.counters["to_matching"] = all_ms / stereo_ms;
}
BENCHMARK(panoramaToLocalMap)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

/// cv::StereoSGBM alone on the same pairs.
void panoramaSgbmAlone(benchmark::State& state) {
  cv::setNumThreads(1);
  StereoCamera camera;
  const Observation& observation = panorama(camera);
  const auto sgbm = cv::StereoSGBM::create(0, 64, 7, 8 * 49, 32 * 49, 1, 31, 10, 100, 1,
                                           cv::StereoSGBM::MODE_SGBM_3WAY);
  cv::Mat disparity;
  for (auto _ : state) {
    for (const View& view : observation.views) sgbm->compute(view.left, view.right, disparity);
  }
}
BENCHMARK(panoramaSgbmAlone)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

/// A robot that drives along two walls, one scan a metre: 30 scans are in every map.
void localMap(benchmark::State& state) {
  RandomStream random(1);
  std::vector<WallPoint> walls;
  for (int i = 0; i < static_cast<int>(state.range(0)); ++i) {
    const auto x = static_cast<float>(random.uniform(-25.0, 25.0));
    const auto y = static_cast<float>(random.normal(i % 2 == 0 ? 7.0 : -6.0, 0.05));
    const float sigma = state.range(1) == 0 ? 0.03F : 0.00129F * (x * x + y * y);
    walls.push_back({x, y, sigma, 1.0F});
  }
  LocalMapBuilder builder(kRange_m, {});
  double x = 0.0;
  for (int i = 0; i < 30; ++i) builder.add({x += 1.0, 0, 0}, false, walls);
  for (auto _ : state) {
    const LocalMap map = builder.add({x += 1.0, 0, 0}, false, walls);
    benchmark::DoNotOptimize(map.cells().data);
  }
}
BENCHMARK(localMap)
    ->ArgNames({"points", "stereo_noise"})
    ->Args({2000, 0})
    ->Args({400, 1})
    ->Unit(benchmark::kMillisecond);

void lidarWalls(benchmark::State& state) {
  RandomStream random(1);
  std::vector<RangePoint> points;
  for (int i = 0; i < 30000; ++i) {
    const auto x = static_cast<float>(random.uniform(-40.0, 40.0));
    if (i % 2 == 0) {
      points.push_back({x, static_cast<float>(random.uniform(-6.0, 7.0)), 0.0F, 1.0F});
    } else {
      points.push_back({x, i % 4 == 1 ? 7.0F : -6.0F, static_cast<float>(random.uniform(0, 3)), 1});
    }
  }
  RangeWalls walls(kRange_m, {});
  for (auto _ : state) benchmark::DoNotOptimize(walls(points, {}));
}
BENCHMARK(lidarWalls)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace handmap
