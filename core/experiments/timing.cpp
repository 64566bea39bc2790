#include "core/experiments/timing.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/experiments/trial_table.h"
#include "core/simulation/simulated_source.h"

namespace handmap {

namespace {

constexpr double kDrawnOff_m = 5.0;
constexpr double kMsPerS = 1000.0;

constexpr auto kTimingNotes =
    "\nSeconds a frame, all stages, median over the frames with its distribution-free 95 % "
    "interval. Published: the paper's own Table I (Matsuo and Miura, IROS 2012, on a machine of "
    "its time). Simulated: six buildings in two rows, range points, drawings 5 m off; swarms of 10 "
    "iterations.\n";

bool drive(std::uint64_t seed, const RunSettings& settings, const std::stop_token& stop,
           std::vector<double>& seconds) {
  const World world = twoRowWorld(seed);
  RunSession session(perturbed(world.map, kDrawnOff_m, seed), simulate(world, {}, seed), settings);
  while (session.step(stop)) {
  }
  if (stop.stop_requested()) return false;
  for (const FrameReport& frame : session.frames()) {
    seconds.push_back(frame.ms.total / kMsPerS);
  }
  return true;
}

std::string labelOf(const FrameTimes& times) {
  if (!times.combination) return nameOf(times.method);
  return fmt::format("{}x{}", times.combination->pso_particles, times.combination->slam_particles);
}

double upperEnd(std::vector<double> values) {
  constexpr double kShare = 0.95;
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(kShare * static_cast<double>(values.size() - 1))];
}

}  // namespace

const std::vector<Combination>& publishedCombinations() {
  static const std::vector<Combination> kCombinations = {{10, 50, 26.0},   {10, 100, 46.0},
                                                         {10, 150, 64.0},  {20, 50, 50.0},
                                                         {20, 100, 106.0}, {20, 150, 126.0}};
  return kCombinations;
}

std::vector<FrameTimes> measureTimes(std::uint64_t seed, int drives, int threads,
                                     const std::stop_token& stop,
                                     const std::function<void(int, int)>& progress) {
  std::vector<FrameTimes> measured;
  for (const Combination& combination : publishedCombinations()) {
    measured.push_back({Method::Paper, combination, {}});
  }
  measured.push_back({Method::Handmap, {}, {}});
  int done = 0;
  for (FrameTimes& times : measured) {
    RunSettings settings;
    settings.method = times.method;
    settings.threads = threads;
    if (times.combination) {
      settings.slam.pso_particles = times.combination->pso_particles;
      settings.slam.slam_particles = times.combination->slam_particles;
    }
    for (int i = 0; i < drives; ++i) {
      settings.seed = seed + static_cast<std::uint64_t>(i);
      if (!drive(settings.seed, settings, stop, times.seconds)) return measured;
      if (progress) progress(++done, drives * static_cast<int>(measured.size()));
    }
  }
  return measured;
}

Report timeReport(const std::vector<FrameTimes>& measured, int threads) {
  Report report;
  report.markdown =
      "# Table 1: processing time of a frame\n"
      "\n| method | swarm | particles | frames | published s | here s | 95 % of frames below s "
      "| times faster |\n"
      "|:-------|------:|----------:|-------:|------------:|-------:|------------------------:"
      "|-------------:|\n";
  report.csv =
      "method,pso_particles,slam_particles,frames,published_s,median_s,low_s,high_s,p95_s\n";
  Chart chart;
  chart.title = "Processing time of a frame here, swarm x particles";
  chart.x_label = "swarm x particles; handmap: ours";
  chart.y_label = "median (ms) with 95 % interval";
  chart.series = {{nameOf(Method::Paper), SeriesLook::Paper, {}},
                  {nameOf(Method::Handmap), SeriesLook::Handmap, {}}};
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const FrameTimes& times = measured[i];
    const Interval median = medianInterval(times.seconds);
    const auto& of = times.combination;
    const auto number = [&](double value) { return of ? fmt::format("{}", value) : ""; };
    const auto count = [&](int value) { return of ? fmt::format("{}", value) : ""; };
    const std::string pso = count(of ? of->pso_particles : 0);
    const std::string slam = count(of ? of->slam_particles : 0);
    const std::string published = number(of ? of->published_s : 0.0);
    const std::string faster =
        of && median.value > 0.0 ? fmt::format("{:.0f}", of->published_s / median.value) : "";
    report.markdown +=
        fmt::format("| {} | {} | {} | {} | {} | {:.4f} [{:.4f}–{:.4f}] | {:.4f} | {} |\n",
                    nameOf(times.method), pso, slam, times.seconds.size(), published, median.value,
                    median.low, median.high, upperEnd(times.seconds), faster);
    report.csv += fmt::format("{},{},{},{},{},{:.6f},{:.6f},{:.6f},{:.6f}\n", nameOf(times.method),
                              pso, slam, times.seconds.size(), published, median.value, median.low,
                              median.high, upperEnd(times.seconds));
    chart.categories.push_back(labelOf(times));
    chart.series[of ? 0 : 1].points.push_back(
        {static_cast<double>(i),
         {kMsPerS * median.value, kMsPerS * median.low, kMsPerS * median.high}});
  }
  report.markdown += kTimingNotes;
  report.markdown +=
      threads == 0 ? "\nEach run on all threads of the machine.\n"
                   : fmt::format("\nEach run on {} thread{}.\n", threads, threads == 1 ? "" : "s");
  report.charts = {{"table1.png", chart}};
  report.markdown += fmt::format("\n![{}](table1.png)\n", chart.title);
  return report;
}

}  // namespace handmap
