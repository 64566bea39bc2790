// Visual odometry beside cv::StereoSGBM on the same images, both on one thread.
#include <benchmark/benchmark.h>
#include <opencv2/calib3d.hpp>

#include "core/odometry/stereo_odometry.h"
#include "core/recording/image_check.h"
#include "tests/core/odometry/drive.h"

namespace handmap {
namespace {

/// A way back and forth in steps of 0.8 m: every motion can be seen.
const std::vector<View>& drive() {
  static const std::vector<View> kViews = [] {
    std::vector<View> result;
    for (int i = 0; i < 6; ++i) result.push_back(test::viewFrom(test::yard(), {0.8 * i, 0, 0}));
    for (int i = 4; i > 0; --i) result.push_back(result[static_cast<std::size_t>(i)]);
    return result;
  }();
  return kViews;
}

void visualOdometry(benchmark::State& state) {
  cv::setNumThreads(1);
  StereoOdometry odometry(test::odometryCamera());
  std::size_t pair = 0;
  double time_s = 0.0;
  double guessed = 0.0;
  double inliers = 0.0;
  for (auto _ : state) {
    const View& view = drive()[pair++ % drive().size()];
    const auto motion = odometry(view.left, view.right, time_s += 0.1);
    if (!motion) continue;
    guessed += motion->guessed;
    inliers += motion->inliers;
  }
  state.counters["guessed"] = benchmark::Counter(guessed, benchmark::Counter::kAvgIterations);
  state.counters["inliers"] = benchmark::Counter(inliers, benchmark::Counter::kAvgIterations);
}
BENCHMARK(visualOdometry)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

/// Where the motion is too large to follow: ORB.
void visualOdometryAfterAJump(benchmark::State& state) {
  cv::setNumThreads(1);
  const View& first = drive().front();
  const View& far = drive()[5];
  double guessed = 0.0;
  for (auto _ : state) {
    state.PauseTiming();
    StereoOdometry odometry(test::odometryCamera());
    odometry(first.left, first.right, 0.0);
    state.ResumeTiming();
    guessed += odometry(far.left, far.right, 1.0)->guessed;
  }
  state.counters["guessed"] = benchmark::Counter(guessed, benchmark::Counter::kAvgIterations);
}
BENCHMARK(visualOdometryAfterAJump)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void sgbm(benchmark::State& state) {
  cv::setNumThreads(1);
  const auto matcher = cv::StereoSGBM::create(0, 128, 7, 8 * 49, 32 * 49, 1, 31, 10, 100, 1,
                                              cv::StereoSGBM::MODE_SGBM_3WAY);
  cv::Mat disparity;
  for (auto _ : state) matcher->compute(drive()[0].left, drive()[0].right, disparity);
}
BENCHMARK(sgbm)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void checkOfAPair(benchmark::State& state) {
  for (auto _ : state) {
    checkPicture(drive()[0].left, "left");
    checkPicture(drive()[0].right, "right");
  }
}
BENCHMARK(checkOfAPair)->Unit(benchmark::kMillisecond);

void swapCheck(benchmark::State& state) {
  for (auto _ : state) SwapCheck()(drive()[0].left, drive()[0].right, "right");
}
BENCHMARK(swapCheck)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace handmap
