// The way from scans beside what it starts from, the recorded odometry: time of an observation, and
// how far off both are.
#include <benchmark/benchmark.h>

#include "core/pose_graph/constants.h"
#include "core/trajectory/returns.h"
#include "core/trajectory/scan_features.h"
#include "core/trajectory/scan_trajectory.h"
#include "core/trajectory/submap.h"
#include "tests/core/pose_graph/ceres_pose_graph.h"
#include "tests/core/trajectory/walled_world.h"

namespace handmap {
namespace {

struct Drive {
  std::vector<Pose2> truth = test::aroundTheBlock(1.5);
  std::vector<Pose2> odometry;
  std::vector<std::vector<RangePoint>> scans;
};

const Drive& drive() {
  static const Drive kDrive = [] {
    Drive drive;
    RandomStream random(1);
    drive.odometry = test::slipping(drive.truth, random);
    const auto walls = test::ringCorridor();
    for (const Pose2& pose : drive.truth) {
      drive.scans.push_back(test::scanFrom(walls, pose, 0.03, random));
    }
    return drive;
  }();
  return kDrive;
}

void waysFromScans(benchmark::State& state) {
  const bool close_loops = state.range(0) != 0;
  double off = 0.0;
  for (auto _ : state) {
    ScanTrajectory trajectory({40.0, close_loops});
    for (std::size_t i = 0; i < drive().scans.size(); ++i) {
      trajectory.add(0.0, drive().odometry[i], drive().scans[i]);
    }
    off = test::rms(trajectory.poses(), drive().truth);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(drive().scans.size()));
  state.counters["rms_m"] = off;
  state.counters["odometry_rms_m"] = test::rms(drive().odometry, drive().truth);
}
BENCHMARK(waysFromScans)->ArgName("loops")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void sharpness(benchmark::State& state) {
  ScanTrajectory trajectory({40.0, false});
  for (std::size_t i = 0; i < drive().scans.size(); ++i) {
    trajectory.add(0.0, drive().odometry[i], drive().scans[i]);
  }
  double recorded = 0.0;
  for (auto _ : state) recorded = trajectory.sharpness(drive().odometry);
  state.counters["recorded"] = recorded;
  state.counters["scans"] = trajectory.sharpness(trajectory.scanPoses());
  state.counters["truth"] = trajectory.sharpness(drive().truth);
}
BENCHMARK(sharpness)->Unit(benchmark::kMillisecond);

/// Where a submap lies in another one, as wide as after a long way and as narrow as at first.
void placeOfASubmap(benchmark::State& state) {
  const bool wide = state.range(0) != 0;
  const std::size_t there = drive().scans.size() / 3;
  const std::vector<ScanPoint> seen = features(usableReturns(drive().scans[there], 40.0));
  const WallGrid grid(seen);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        grid.find(seen, {1.0, -0.7, 0.02}, {wide ? 12.0 : 2.5, wide ? 0.22 : 0.06}));
  }
}
BENCHMARK(placeOfASubmap)->ArgName("wide")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

PoseGraph rounds(const benchmark::State& state) {
  RandomStream random(1);
  return test::roundsAlongASquare(static_cast<std::size_t>(state.range(0)), random);
}

void poseGraph(benchmark::State& state) {
  PoseGraph graph = rounds(state);
  for (auto _ : state) {
    graph = rounds(state);
    benchmark::DoNotOptimize(graph.optimize(50));
  }
  state.counters["cost"] = graph.cost(graph.poses());
}
BENCHMARK(poseGraph)->ArgName("rounds")->Arg(2)->Arg(5)->Arg(15)->Unit(benchmark::kMillisecond);

void poseGraphByCeres(benchmark::State& state) {
  std::vector<Pose2> found;
  for (auto _ : state) found = test::byCeres(rounds(state), pose_graph::kLeastGain);
  state.counters["cost"] = rounds(state).cost(found);
}
BENCHMARK(poseGraphByCeres)
    ->ArgName("rounds")
    ->Arg(2)
    ->Arg(5)
    ->Arg(15)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace handmap
