// What a run costs: its observations, its snapshots, and how soon it hears that it shall stop.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <random>
#include <string>
#include <thread>

#include <Eigen/Core>
#include <benchmark/benchmark.h>
#include <pthread.h>
#include <time.h>

#include "core/map/map_io.h"
#include "core/recording/recording.h"
#include "core/session/run_session.h"
#include "core/simulation/simulated_source.h"

namespace handmap {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// Two rows along the x axis; the robot is at their beginning.
Map rows(int buildings) {
  Map map;
  map.start = Pose2{};
  for (int i = 0; i < buildings; ++i) {
    Building building;
    building.id = std::to_string(i);
    const int column = i / 2;
    building.shape = Rectangle{{30.0 * column, i % 2 == 0 ? 15.0 : -15.0}, 20.0, 10.0, 0.0};
    map.buildings.push_back(building);
  }
  return map;
}

/// A robot that creeps: most observations only move it, so that many are soon worked in.
class CreepingSource : public ObservationSource {
 public:
  explicit CreepingSource(int count) { info_.observations = count; }
  const SourceInfo& info() const override { return info_; }
  std::optional<Observation> next() override {
    if (next_ == info_.observations) return std::nullopt;
    Observation observation;
    observation.frame = next_;
    observation.time_s = 0.1 * next_;
    observation.odometry = {1e-4 * next_++, 0.0, 0.0};
    auto& points = observation.views.emplace_back().points.emplace();
    for (float x = -10.0F; x < 10.0F; x += 0.2F) {
      points.push_back({x, 10.0F, 1.0F, 1.0F});
      points.push_back({x, -10.0F, 1.0F, 1.0F});
    }
    return observation;
  }

 private:
  SourceInfo info_;
  int next_ = 0;
};

/// A real street with cameras, or its lidar, with another drawing: from what was perceived before.
void doneAgain(benchmark::State& state) {
  const std::filesystem::path street = std::filesystem::path(HANDMAP_SHARED_DATA) / "street";
  if (!std::filesystem::exists(street)) return state.SkipWithError("needs the street");
  ReplayOptions options;
  options.from = 38;
  options.kind = state.range(0) == 0 ? SourceKind::Images : SourceKind::Points;
  constexpr TapeLimits kAll{2U << 30U, 0};
  const auto tape =
      std::make_shared<Tape>(replay(openRecording(street), options), PerceptionOptions{}, kAll);
  const auto run = [&](const char* drawing) {
    RunSession session(readMap(street / drawing), tape, {});
    while (session.step()) {
    }
  };
  const auto begin = Clock::now();
  run("sketch-a.handmap");
  state.counters["first_ms"] = millisecondsSince(begin);
  for (auto _ : state) run("sketch-b.handmap");
}
BENCHMARK(doneAgain)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

/// What a product of two matrices of 256 × 256 takes on this machine, just now.
double productMs() {
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(256, 256);
  std::vector<double> all;
  for (int i = 0; i < 21; ++i) {
    const auto begin = Clock::now();
    benchmark::DoNotOptimize(Eigen::MatrixXd(a * a).data());
    all.push_back(millisecondsSince(begin));
  }
  std::ranges::nth_element(all, all.begin() + 10);
  return all[10];
}

struct Place {
  const char* folder;
  const char* drawing = "sketch-a";
  int from = 0;
  SourceKind kind = SourceKind::Points;
};

/// Reading, judging and estimating of one observation of real and simulated places, on one thread:
/// the slowest of twenty, that beside a product of matrices, and the slowest of all.
void observation(benchmark::State& state, const Place& place) {
  const std::filesystem::path folder = std::filesystem::path(HANDMAP_SHARED_DATA) / place.folder;
  if (!std::filesystem::exists(folder)) return state.SkipWithError("needs the place");
  const Map drawing = readMap(folder / (std::string(place.drawing) + ".handmap"));
  ReplayOptions options;
  options.from = place.from;
  options.kind = place.kind;
  RunSettings settings;
  settings.threads = 1;
  std::vector<double> all;
  for (auto _ : state) {
    auto source = replay(openRecording(folder), options);
    const auto last = static_cast<std::size_t>(source->info().observations);
    RunSession session(drawing, std::move(source), settings);
    while (session.frames().size() < last && session.step()) {
    }
    for (const FrameReport& frame : session.frames()) all.push_back(frame.ms.total);
  }
  std::ranges::sort(all);
  const double p95 = all[all.size() * 95 / 100];
  state.counters["p95_ms"] = p95;
  state.counters["p95_products"] = p95 / productMs();
  state.counters["longest_ms"] = all.back();
}
BENCHMARK_CAPTURE(observation, campus, Place{"campus", "sketch-d"})->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(observation, corner, Place{"corner"})->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(observation, street_by_lidar, Place{"street", "sketch-a", 40})
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(observation, street_by_images,
                  Place{"street", "sketch-a", 40, SourceKind::Images})
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(observation, boulevard, Place{"boulevard/dense"})->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(observation, rough_quarter, Place{"laser-sim/rough-1"})->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(observation, terrace, Place{"laser-sim/terrace-1"})->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(observation, town, Place{"laser-sim/town"})->Unit(benchmark::kSecond);

/// Of the last of as many frames: all of a step that its report does not count as its own.
void snapshot(benchmark::State& state) {
  constexpr int kMeasured = 50;
  const auto buildings = static_cast<int>(state.range(0));
  const auto frames = static_cast<int>(state.range(1));
  RunSettings settings;
  settings.threads = 1;
  RunSession session(rows(buildings), std::make_unique<CreepingSource>(frames + kMeasured + 1),
                     settings);
  for (int i = 0; i < frames; ++i) session.step();
  for (auto _ : state) {
    const auto begin = Clock::now();
    const auto shown = session.step();
    state.SetIterationTime((millisecondsSince(begin) - shown->report.ms.total) / 1e3);
  }
}
BENCHMARK(snapshot)
    ->ArgsProduct({{10, 10'000}, {100, 10'000}})
    ->ArgNames({"buildings", "frame"})
    ->Iterations(50)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

/// What a thread has worked, which others on the machine leave as it is.
class WorkClock {
 public:
  WorkClock() { pthread_getcpuclockid(pthread_self(), &clock_); }
  /// Of the thread that made it; from any thread.
  double milliseconds() const {
    timespec now{};
    clock_gettime(clock_, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
  }

 private:
  clockid_t clock_{};
};

/// From requests to stop to the end of their steps, milliseconds: by the wall, and worked.
struct Latencies {
  std::vector<double> wall;
  std::vector<double> worked;
};

/// Steps until the end and asks at random moments to stop.
void measureLatencies(RunSession& session, std::mt19937& random, Latencies& latencies_ms) {
  const WorkClock clock;
  double step_ms = 20.0;  // of the latest whole step: within it a stop is to come
  for (;;) {
    std::stop_source stop;
    Clock::time_point asked;
    double worked = 0.0;
    const double wait_ms = std::uniform_real_distribution(0.0, 2.0 * step_ms)(random);
    std::thread asking([&] {
      std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(wait_ms));
      asked = Clock::now();
      worked = clock.milliseconds();
      stop.request_stop();
    });
    const auto begin = Clock::now();
    const auto shown = session.step(stop.get_token());
    const auto ended = Clock::now();
    const double worked_at_end = clock.milliseconds();
    asking.join();
    if (asked < ended) {
      latencies_ms.wall.push_back(std::chrono::duration<double, std::milli>(ended - asked).count());
      latencies_ms.worked.push_back(worked_at_end - worked);
    } else if (shown) {
      step_ms = std::chrono::duration<double, std::milli>(ended - begin).count();
    } else {
      return;
    }
  }
}

RunSession driveAround(std::uint64_t seed, double step_m) {
  const World world = loopWorld(seed);
  return RunSession(perturbed(world.map, 4.0, seed), simulate(world, atStep({}, step_m), seed), {});
}

void report(benchmark::State& state, Latencies latencies_ms) {
  state.counters["stops"] = static_cast<double>(latencies_ms.wall.size());
  const auto count = [&state](std::vector<double>& of, const std::string& suffix) {
    std::sort(of.begin(), of.end());
    const auto quantile = [&of](double share) {
      const auto at = static_cast<std::size_t>(share * static_cast<double>(of.size() - 1));
      return of.empty() ? 0.0 : of[at];
    };
    state.counters["p50_" + suffix] = quantile(0.5);
    state.counters["p99_" + suffix] = quantile(0.99);
    state.counters["worst_" + suffix] = quantile(1.0);
  };
  count(latencies_ms.wall, "ms");
  count(latencies_ms.worked, "worked_ms");
}

/// Over drives of more than 500 observations around campuses, half the steps are asked to stop.
void stopping(benchmark::State& state) {
  std::mt19937 random(1);
  Latencies latencies_ms;
  for (auto _ : state) {
    for (const std::uint64_t seed : {1U, 2U}) {
      RunSession session = driveAround(seed, 2.0);
      measureLatencies(session, random, latencies_ms);
    }
  }
  report(state, std::move(latencies_ms));
}
BENCHMARK(stopping)->Iterations(1)->Unit(benchmark::kSecond);

/// The same within what is done once the source is at its end.
void stoppingAtTheEnd(benchmark::State& state) {
  constexpr std::uint64_t kDrives = 20;
  const WorkClock clock;
  std::mt19937 random(1);
  Latencies latencies_ms;
  double whole_ms = 1000.0;
  for (auto _ : state) {
    for (std::uint64_t seed = 1; seed <= kDrives; ++seed) {
      RunSession session = driveAround(seed, 5.0);
      while (session.frames().size() < static_cast<std::size_t>(session.source().observations)) {
        session.step();
      }
      std::stop_source stop;
      Clock::time_point asked = Clock::time_point::max();
      double worked = 0.0;
      const double wait_ms =
          seed == 1 ? 1e4 : std::uniform_real_distribution(0.0, whole_ms)(random);
      std::atomic<bool> over = false;
      std::thread asking([&] {
        const auto until = Clock::now() + std::chrono::duration<double, std::milli>(wait_ms);
        while (!over && Clock::now() < until) {
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        if (over) return;
        asked = Clock::now();
        worked = clock.milliseconds();
        stop.request_stop();
      });
      const auto begin = Clock::now();
      session.step(stop.get_token());
      const auto ended = Clock::now();
      const double worked_at_end = clock.milliseconds();
      over = true;
      asking.join();
      if (asked < ended) {
        latencies_ms.wall.push_back(
            std::chrono::duration<double, std::milli>(ended - asked).count());
        latencies_ms.worked.push_back(worked_at_end - worked);
      } else {
        whole_ms = std::chrono::duration<double, std::milli>(ended - begin).count();
      }
    }
  }
  state.counters["whole_ms"] = whole_ms;
  report(state, std::move(latencies_ms));
}
BENCHMARK(stoppingAtTheEnd)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace handmap
