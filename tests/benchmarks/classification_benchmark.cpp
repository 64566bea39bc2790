// Finding buildings in a 640×480 image (1,200 windows), beside cv::StereoSGBM on the same pair at
// half resolution.
#include <benchmark/benchmark.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/random.h"
#include "core/classification/training.h"

namespace handmap {
namespace {

/// Blocks of many sizes: edges and flat areas, about as many as in a street.
const cv::Mat3b& street() {
  static const cv::Mat3b kImage = [] {
    RandomStream random(1);
    cv::Mat3b blocks(480, 640, cv::Vec3b(180, 180, 190));
    for (int i = 0; i < 600; ++i) {
      const int side = 4 + random.index(60);
      const cv::Scalar colour(random.index(256), random.index(256), random.index(256));
      cv::rectangle(blocks, cv::Rect(random.index(640), random.index(480), side, side), colour,
                    cv::FILLED);
    }
    return blocks;
  }();
  return kImage;
}

/// Of full size; what it says does not matter here.
const BuildingClassifier& classifier(bool colour, bool trees) {
  const auto train = [](bool in_colour, bool of_trees) {
    TrainingSet set({of_trees ? FeatureFamily::Equalized : FeatureFamily::Handmap, in_colour});
    std::vector<WindowLabel> labels(1200);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      labels[i] = i % 40 < 20 ? WindowLabel::Building : WindowLabel::Other;
    }
    set.add(street(), labels);
    return trainClassifier(set, {.trees = of_trees}).value();
  };
  static const BuildingClassifier kInColour = train(true, false);
  static const BuildingClassifier kInGrey = train(false, false);
  static const BuildingClassifier kOfTrees = train(true, true);
  if (trees) return kOfTrees;
  return colour ? kInColour : kInGrey;
}

void classify(benchmark::State& state) {
  const BuildingClassifier& judge = classifier(state.range(0) != 0, state.range(2) != 0);
  cv::Mat1b wanted = noWindows(street().size());
  for (int i = 0; i < 1200; ++i) {
    wanted(i / 40, i % 40) = i % 100 < state.range(1) ? 1 : 0;
  }
  for (auto _ : state) benchmark::DoNotOptimize(judge.probabilities(street(), wanted).data);
}
BENCHMARK(classify)
    ->ArgNames({"colour", "wanted_%", "trees"})
    ->Args({1, 100, 0})
    ->Args({0, 100, 0})
    ->Args({1, 40, 0})
    ->Args({0, 40, 0})
    ->Args({1, 100, 1})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

void featuresAlone(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(windowFeatures(street(), {}).data());
}
BENCHMARK(featuresAlone)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

/// As core/perception uses it: three ways, 64 disparities.
void sgbmAtHalfResolution(benchmark::State& state) {
  cv::Mat left;
  cv::Mat right;
  cv::resize(street(), left, {}, 0.5, 0.5, cv::INTER_AREA);
  cv::cvtColor(left, left, cv::COLOR_BGR2GRAY);
  const cv::Mat1d shift = (cv::Mat1d(2, 3) << 1, 0, -12, 0, 1, 0);
  cv::warpAffine(left, right, shift, left.size());
  const auto sgbm = cv::StereoSGBM::create(0, 64, 7, 8 * 49, 32 * 49, 1, 31, 10, 100, 1,
                                           cv::StereoSGBM::MODE_SGBM_3WAY);
  cv::Mat disparity;
  for (auto _ : state) sgbm->compute(left, right, disparity);
}
BENCHMARK(sgbmAtHalfResolution)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

}  // namespace
}  // namespace handmap
