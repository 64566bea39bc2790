#include "app/cli/evaluate_runs.h"

#include <filesystem>

#include <fmt/format.h>

#include "app/cli/interrupt.h"
#include "app/cli/share_progress.h"
#include "core/experiments/reliability.h"
#include "core/experiments/timing.h"
#include "core/map/map_io.h"
#include "core/trajectory/odometry_choice.h"

namespace handmap {

namespace {

constexpr int kUsualDrives = 3;
constexpr int kUsualTrials = 10;

std::optional<RunStatements> observe(const RealRun& run, const std::stop_token& stop) {
  const Map truth = readMap(run.truth);
  auto source =
      replayWithOdometry(openRecording(run.recording), run.replay, OdometryKind::Recorded).source;
  RunSession session(readMap(run.map), std::move(source), {});
  const auto folder = std::filesystem::path(run.recording).lexically_normal();
  return observeRun(
      fmt::format("{}, {}",
                  (folder.has_filename() ? folder : folder.parent_path()).filename().string(),
                  std::filesystem::path(run.map).stem().string()),
      session, &truth, stop);
}

}  // namespace

std::optional<Report> evaluateTimes(std::uint64_t seed, int trials, int threads) {
  const Interrupt interrupt;
  ShareProgress progress;
  const auto measured = measureTimes(
      seed, trials > 0 ? trials : kUsualDrives, threads, interrupt.token(), [&](int done, int all) {
        progress.update(fmt::format("drive {} of {}", done, all), static_cast<double>(done) / all);
      });
  if (interrupt.requested()) return std::nullopt;
  return timeReport(measured, threads);
}

std::optional<Report> evaluateReliability(const Experiment& experiment, int trials,
                                          const std::vector<RealRun>& real) {
  const Interrupt interrupt;
  ShareProgress progress;
  Experiment simulated = experiment;
  simulated.methods = {Method::Handmap};
  simulated.trials = trials > 0 ? trials : kUsualTrials;
  const std::vector<TrialKey> keys = trialsOf(simulated);
  std::vector<RunStatements> runs;
  const auto tell = [&] {
    const auto all = keys.size() + real.size();
    progress.update(fmt::format("run {} of {}", runs.size(), all),
                    static_cast<double>(runs.size()) / static_cast<double>(all));
  };
  for (const RealRun& run : real) {
    auto statements = observe(run, interrupt.token());
    if (!statements) return std::nullopt;
    runs.push_back(std::move(*statements));
    tell();
  }
  for (const TrialKey& key : keys) {
    auto statements = observeTrial(key, simulated.settings, interrupt.token());
    if (!statements) return std::nullopt;
    runs.push_back(std::move(*statements));
    tell();
  }
  return reliabilityReport(runs);
}

}  // namespace handmap
