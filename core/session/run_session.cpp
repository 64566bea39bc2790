#include "core/session/run_session.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/session/estimation_method.h"
#include "core/session/run_report.h"

namespace handmap {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

std::optional<Pose2> poseAt(const std::vector<StampedPose>& poses, double time_s) {
  const auto same =
      std::lower_bound(poses.begin(), poses.end(), time_s,
                       [](const StampedPose& pose, double time) { return pose.time_s < time; });
  if (same == poses.end()) return std::nullopt;
  if (same->time_s == time_s) return same->pose;
  if (same == poses.begin()) return std::nullopt;
  const StampedPose& before = *(same - 1);
  return interpolated(before.pose, same->pose,
                      (time_s - before.time_s) / (same->time_s - before.time_s));
}

}  // namespace

struct RunSession::State {
  State(Map map, std::unique_ptr<ObservationSource> from, const RunSettings& with)
      : drawing(std::move(map)),
        source(std::move(from)),
        settings(with),
        perception(source->info(), settings.perception),
        method(makeMethod(drawing, source->info(), settings)),
        arena(settings.threads) {}

  std::optional<Observation> nextReadable(const std::stop_token& stop,
                                          const std::function<void(double)>& progress);
  /// Every observation's; else it is rendered for whoever looks at it.
  bool readsLocalMap() const { return settings.method == Method::Paper; }
  std::optional<Percept> perceive(const Observation& observation, const std::stop_token& stop);
  std::shared_ptr<const Snapshot> snapshot(const Observation& observation, Percept percept);
  std::shared_ptr<const Snapshot> lastSnapshot(const std::stop_token& stop,
                                               const std::function<void(double)>& progress);
  void fill(Snapshot& snapshot) const;
  std::function<Map()> refinedMap() const;

  Map drawing;
  std::unique_ptr<ObservationSource> source;
  RunSettings settings;
  Perception perception;
  std::unique_ptr<EstimationMethod> method;
  Arena arena;
  SharedListWriter<StampedPose> odometry;  ///< alone, from the drawing's start
  std::vector<FrameReport> frames;
  std::vector<SkippedFrame> skipped;
  RunCounts counts;
  std::shared_ptr<const Snapshot> newest;
  bool finished = false;
  Clock::time_point begin = Clock::now();
};

RunSession::RunSession(Map drawing, std::unique_ptr<ObservationSource> source,
                       const RunSettings& settings)
    : state_(std::make_unique<State>(std::move(drawing), std::move(source), settings)) {}

RunSession::~RunSession() = default;

const SourceInfo& RunSession::source() const { return state_->source->info(); }
const std::vector<SkippedFrame>& RunSession::skipped() const { return state_->skipped; }
const std::vector<FrameReport>& RunSession::frames() const { return state_->frames; }

/// nullopt at the end of the source and when `stop` was requested.
std::optional<Observation> RunSession::State::nextReadable(
    const std::stop_token& stop, const std::function<void(double)>& progress) {
  while (!stop.stop_requested()) {
    try {
      return source->next();
    } catch (const FrameError& error) {
      skipped.push_back({error.frame(), error.what()});
    }
    if (progress) progress(0.0);
  }
  return std::nullopt;
}

std::optional<Percept> RunSession::State::perceive(const Observation& observation,
                                                   const std::stop_token& stop) {
  try {
    return perception(observation, stop);
  } catch (const Error& error) {
    skipped.push_back({observation.frame, error.what()});
    return std::nullopt;
  }
}

std::shared_ptr<const Snapshot> RunSession::step(const std::stop_token& stop,
                                                 const std::function<void(double)>& progress) {
  State& state = *state_;
  while (!stop.stop_requested()) {
    const auto begin = Clock::now();
    const std::optional<Observation> observation = state.nextReadable(stop, progress);
    if (stop.stop_requested()) return nullptr;
    if (!observation) {
      if (!state.frames.empty()) return state.lastSnapshot(stop, progress);
      const int count = source().observations;
      throw Error(ErrorCode::RunFailed,
                  fmt::format("none of {} could be used{}{}",
                              count > 0 ? fmt::format("{} observations", count) : "what came",
                              state.skipped.empty() ? "" : "; the first: ",
                              state.skipped.empty() ? "" : state.skipped.front().reason));
    }
    std::optional<Percept> percept = state.perceive(*observation, stop);
    if (!percept) continue;

    FrameReport report;
    report.ms.read = observation->read_ms;
    report.ms.stereo = percept->stereo_ms;
    report.ms.classify = percept->classify_ms;
    report.ms.local_map = percept->local_map_ms;
    if (state.readsLocalMap()) {
      const auto render_begin = Clock::now();
      percept->local_map.get();
      report.ms.local_map += millisecondsSince(render_begin);
    }
    const auto slam_begin = Clock::now();
    bool done = false;
    state.arena.execute([&] {
      done =
          state.method->step(observation->time_s, observation->odometry, *percept, stop, progress);
    });
    if (!done) return nullptr;
    report.ms.slam = millisecondsSince(slam_begin);
    report.ms.total = millisecondsSince(begin);
    report.frame = observation->frame;
    report.time_s = observation->time_s;
    report.odometry_guessed = observation->odometry_guessed;
    state.method->describe(report);
    state.frames.push_back(report);
    state.counts.add(*observation, *percept, report);
    return state.snapshot(*observation, std::move(*percept));
  }
  return nullptr;
}

std::shared_ptr<const Snapshot> RunSession::State::snapshot(const Observation& observation,
                                                            Percept percept) {
  const Pose2 driven = between(source->info().start_odometry, observation.odometry);
  odometry.push_back({observation.time_s, *drawing.start * driven});

  auto snapshot = std::make_shared<Snapshot>();
  snapshot->index = static_cast<int>(frames.size() + skipped.size());
  snapshot->count = source->info().observations;
  fill(*snapshot);
  snapshot->odometry = odometry.share();
  snapshot->truth = poseAt(source->info().truth, observation.time_s);
  snapshot->local_map = std::move(percept.local_map);
  snapshot->image = percept.image;
  snapshot->disparity = percept.disparity;
  snapshot->buildings = percept.buildings;
  newest = snapshot;
  return snapshot;
}

/// What the end of the run has changed.
std::shared_ptr<const Snapshot> RunSession::State::lastSnapshot(
    const std::stop_token& stop, const std::function<void(double)>& progress) {
  if (finished) return nullptr;
  finished = true;
  bool changed = false;
  arena.execute([&] { changed = method->finish(stop, progress); });
  if (!changed) return nullptr;
  method->describe(frames.back());
  auto snapshot = std::make_shared<Snapshot>(*newest);
  fill(*snapshot);
  return snapshot;
}

void RunSession::State::fill(Snapshot& snapshot) const {
  snapshot.report = frames.back();
  snapshot.particles = method->particles();
  snapshot.swarms.clear();
  for (const BuildingSwarm& swarm : method->swarms()) {
    SwarmView view{swarm.building, {}};
    for (const Rectangle& box : swarm.members) {
      view.members.push_back(drawing.buildings[swarm.building].fitted(box).footprint());
    }
    snapshot.swarms.push_back(std::move(view));
  }
  snapshot.map = Lazy<Map>(refinedMap());
  snapshot.trajectory = method->trajectory();
}

std::vector<StampedPose> RunSession::trajectory() const {
  return state_->method->trajectory().all();
}

std::function<Map()> RunSession::State::refinedMap() const {
  return
      [make = method->refinedMap(), refinement = refinementJson(settings, source->info(), frames)] {
        Map map = make();
        map.refinement = refinement;
        return map;
      };
}

Map RunSession::refinedMap() const { return state_->refinedMap()(); }

std::vector<RunWarning> RunSession::warnings() const {
  const RunSettings& settings = state_->settings;
  return runWarnings({state_->counts, source().range_limit_m, state_->drawing,
                      state_->method->refinedMap()(), trajectory(), settings.slam.refine});
}

std::string RunSession::reportJson() const {
  const double wall_s = millisecondsSince(state_->begin) / 1000.0;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const double peak_memory_mb = static_cast<double>(usage.ru_maxrss) / 1024.0;
  return runReportJson({state_->settings, source(), state_->frames, state_->skipped, warnings(),
                        state_->method->refinedMap()(), wall_s, peak_memory_mb});
}

}  // namespace handmap
