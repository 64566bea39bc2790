#include "core/session/run_session.h"

#include <algorithm>
#include <limits>
#include <map>
#include <mutex>

#include <malloc.h>
#include <sys/resource.h>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/phrase.h"
#include "core/method/estimation_method.h"
#include "core/method/given_start.h"
#include "core/method/pose_trust.h"
#include "core/method/seen_place.h"
#include "core/odometry/given_poses.h"
#include "core/session/run_report.h"

namespace handmap {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kAhead = std::size_t{256} << 20U;  // bytes of pictures that wait for the run

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

/// Whoever is told of the progress may have the run wait; that is not the time of a step. Told from
/// any thread: times that overlap count once.
class Waiting {
 public:
  explicit Waiting(const std::function<void(double)>& progress) : progress_(progress) {}

  std::function<void(double)> progress() {
    if (!progress_) return {};
    return [this](double share) {
      const auto told = Clock::now();
      progress_(share);
      const std::scoped_lock lock(mutex_);
      ms_ += millisecondsSince(std::max(told, counted_to_));
      counted_to_ = Clock::now();
    };
  }
  double ms() const { return ms_; }

 private:
  const std::function<void(double)>& progress_;
  std::mutex mutex_;
  Clock::time_point counted_to_{};
  double ms_ = 0.0;
};

/// Where poses are given it is looked twice at what leads to them.
TapeLimits limits(const RunSettings& settings) {
  if (settings.given_poses.empty()) return {};
  return {TapeLimits::toDoAgain().memory, std::numeric_limits<std::size_t>::max()};
}

}  // namespace

struct RunSession::State {
  State(Map map, std::shared_ptr<Tape> from, const RunSettings& with)
      : drawing(std::move(map)),
        drawn_start(drawing.start),
        tape(std::move(from)),
        settings(with),
        local_maps(source().range_limit_m, settings.perception.local_map),
        method(makeMethod(drawing, source(), settings)),
        arena(settings.threads) {
    counts.images = source().camera.has_value();
    if (!settings.given_poses.empty()) given = bent();
  }

  const SourceInfo& source() const { return tape->info(); }
  bool begin(const std::stop_token& stop, const std::function<void(double)>& progress);
  std::vector<StampedPose> allOdometry() const {
    return source().odometry.empty() ? tape->odometry() : source().odometry;
  }
  bool lookAlong(GivenStart& start, const std::stop_token& stop,
                 const std::function<void(double)>& progress);
  void keepAhead(std::size_t n, const Pictures& pictures);
  GivenPoses bent() const {
    return {*drawing.start, source().start_odometry, allOdometry(), settings.given_poses};
  }
  bool isElsewhere(const Percept& first) const;
  std::optional<Tape::Taken> nextReadable(const std::stop_token& stop,
                                          const std::function<void(double)>& progress);
  /// Every observation's; else it is rendered for whoever looks at it.
  bool readsLocalMap() const { return settings.method == Method::Paper; }
  /// What is of the observation alone.
  void fillSeen(Snapshot& snapshot, const Tape::Taken& seen, const LazyLocalMap& local_map) const;
  std::shared_ptr<const Snapshot> snapshot(const Tape::Taken& seen, const LazyLocalMap& local_map,
                                           PhaseRecorder* phases);
  std::optional<PhaseRecorder> recorder(const Tape::Taken& seen,
                                        const LazyLocalMap& local_map) const;
  std::shared_ptr<const Snapshot> lastSnapshot(const std::stop_token& stop,
                                               const std::function<void(double)>& progress);
  void fill(Snapshot& snapshot) const;
  void describe(FrameReport& report) const {
    method->describe(report);
    report.start_refuted = start_refuted;
    stateBlind(start_refuted ? std::max(blind_s, method::kCarried_s) : blind_s, report);
  }
  std::function<Map()> refinedMap() const;

  Map drawing;
  std::optional<Pose2> drawn_start;  ///< that of `drawing` may be told by poses that were given
  std::shared_ptr<Tape> tape;
  std::size_t taken = 0;  ///< of the tape
  /// Of what was looked at before the run came there: they are there once, for whoever looks at it.
  std::map<std::size_t, Pictures> ahead;
  std::size_t ahead_bytes = 0;
  RunSettings settings;
  GivenPoses given;
  LocalMapBuilder local_maps;
  std::unique_ptr<EstimationMethod> method;
  Arena arena;
  SharedListWriter<StampedPose> odometry;  ///< alone, from the drawing's start
  std::vector<FrameReport> frames;
  std::vector<SkippedFrame> skipped;
  RunCounts counts;
  std::shared_ptr<const Snapshot> newest;
  double blind_s = 0.0;  ///< of the newest observation
  bool start_refuted = false;
  bool begun = false;
  bool finished = false;
  bool tracing = false;
  Clock::time_point born = Clock::now();
};

RunSession::RunSession(Map drawing, std::unique_ptr<ObservationSource> source,
                       const RunSettings& settings)
    : RunSession(std::move(drawing),
                 std::make_shared<Tape>(std::move(source), settings.perception, limits(settings)),
                 settings) {}

RunSession::RunSession(Map drawing, std::shared_ptr<Tape> tape, const RunSettings& settings)
    : state_(std::make_unique<State>(std::move(drawing), std::move(tape), settings)) {}

RunSession::~RunSession() = default;

const SourceInfo& RunSession::source() const { return state_->source(); }
void RunSession::setTracing(bool on) { state_->tracing = on; }

const std::vector<SkippedFrame>& RunSession::skipped() const { return state_->skipped; }
const std::vector<FrameReport>& RunSession::frames() const { return state_->frames; }

void RunSession::State::keepAhead(std::size_t n, const Pictures& pictures) {
  if (pictures.image.empty()) return;
  for (const cv::Mat& picture :
       {pictures.image, cv::Mat(pictures.disparity), cv::Mat(pictures.buildings)}) {
    ahead_bytes += picture.total() * picture.elemSize();
  }
  if (ahead_bytes < kAhead) ahead.emplace(n, pictures);
}

/// The way to the last given pose. False where `stop` was requested.
bool RunSession::State::lookAlong(GivenStart& start, const std::stop_token& stop,
                                  const std::function<void(double)>& progress) {
  for (std::size_t n = 0; !start.isDone(); ++n) {
    const std::optional<Tape::Taken> next = tape->take(n, stop);
    if (stop.stop_requested()) return false;
    if (!next) break;
    if (progress) progress(0.0);
    keepAhead(n, next->pictures);
    if (const auto& seen = next->entry.perceived) {
      const Observation& observation = seen->observation;
      start.add(observation.time_s, {observation.odometry, observation.odometry_variance},
                seen->percept, stop);
    }
  }
  return true;
}

/// Poses that were given may tell where it started; where no matched scans lead there the odometry
/// is bent, too. Returns false, to be done anew, when `stop` was requested.
bool RunSession::State::begin(const std::stop_token& stop,
                              const std::function<void(double)>& progress) {
  if (begun) return true;
  if (!settings.given_poses.empty() && settings.method == Method::Handmap) {
    GivenStart start(drawing, source(), settings.given_poses);
    if (!lookAlong(start, stop, progress)) return false;
    drawing = start.drawing();
    given = start.isByScans() ? GivenPoses() : bent();
    method = makeMethod(drawing, source(), settings);
  }
  begun = true;
  return true;
}

/// By the first observation. Whoever says where it was says so of the start, too.
bool RunSession::State::isElsewhere(const Percept& first) const {
  return settings.seen_at_start && settings.given_poses.empty() &&
         settings.seen_at_start->isRefutedBy(first.points, source().range_limit_m);
}

/// nullopt at the end of the source and when `stop` was requested.
std::optional<Tape::Taken> RunSession::State::nextReadable(
    const std::stop_token& stop, const std::function<void(double)>& progress) {
  while (!stop.stop_requested()) {
    std::optional<Tape::Taken> next = tape->take(taken, stop);
    if (!next) return std::nullopt;
    if (auto pictures = ahead.extract(taken)) next->pictures = std::move(pictures.mapped());
    ++taken;
    if (next->entry.perceived) return next;
    skipped.push_back(*next->entry.skipped);
    if (progress) progress(0.0);
  }
  return std::nullopt;
}

std::shared_ptr<const Snapshot> RunSession::step(const std::stop_token& stop,
                                                 const std::function<void(double)>& progress) {
  State& state = *state_;
  const auto begin = Clock::now();
  if (!state.begin(stop, progress)) return nullptr;
  const std::optional<Tape::Taken> taken = state.nextReadable(stop, progress);
  if (stop.stop_requested()) return nullptr;
  if (!taken) {
    if (!state.frames.empty()) return state.lastSnapshot(stop, progress);
    const int count = source().observations;
    throw Error(
        ErrorCode::RunFailed,
        phrase(
            "none of {} could be used{}",
            count > 0 ? phrase("{} observations", count) : phrase("what came"),
            state.skipped.empty() ? "" : phrase("; the first: {}", state.skipped.front().reason)));
  }
  const Observation& observation = taken->entry.perceived->observation;
  const Percept& percept = taken->entry.perceived->percept;
  const auto local_map_begin = Clock::now();
  const LazyLocalMap local_map =
      state.local_maps.add(observation.odometry, observation.standing, percept.walls);
  if (state.readsLocalMap()) local_map.get();
  FrameReport report;
  report.ms.read = observation.read_ms;
  report.ms.stereo = percept.stereo_ms;
  report.ms.classify = percept.classify_ms;
  report.ms.local_map = millisecondsSince(local_map_begin);
  const auto slam_begin = Clock::now();
  Waiting waiting(progress);
  bool done = false;
  const Odometry odometry{state.given(observation.time_s, observation.odometry),
                          observation.odometry_variance + state.given.variance(observation.time_s)};
  auto phases = state.recorder(*taken, local_map);
  state.method->trace(phases ? &*phases : nullptr);
  state.arena.execute([&] {
    done = state.method->step(observation.time_s, odometry, percept, local_map, stop,
                              waiting.progress());
  });
  state.method->trace(nullptr);
  if (!done) return nullptr;
  report.ms.slam = millisecondsSince(slam_begin) - waiting.ms();
  report.ms.total = millisecondsSince(begin) - waiting.ms();
  report.frame = observation.frame;
  report.time_s = observation.time_s;
  report.odometry_guessed = observation.odometry_guessed;
  state.blind_s = observation.blind_s;
  if (state.frames.empty()) state.start_refuted = state.isElsewhere(percept);
  state.describe(report);
  state.frames.push_back(report);
  state.counts.add(percept, report);
  return state.snapshot(*taken, local_map, phases ? &*phases : nullptr);
}

void RunSession::State::fillSeen(Snapshot& snapshot, const Tape::Taken& seen,
                                 const LazyLocalMap& local_map) const {
  const Observation& observation = seen.entry.perceived->observation;
  snapshot.index = static_cast<int>(frames.size() + skipped.size());
  snapshot.count = source().observations;
  snapshot.report.frame = observation.frame;
  snapshot.report.time_s = observation.time_s;
  snapshot.driven = observation.odometry;
  snapshot.truth = poseAt(source().truth, observation.time_s);
  snapshot.local_map = local_map;
  snapshot.image = seen.pictures.image;
  snapshot.disparity = seen.pictures.disparity;
  snapshot.buildings = seen.pictures.buildings;
  snapshot.pictured = observation.frame;
  snapshot.panning = seen.pictures.panning;
  snapshot.seen = PastSight(tape, taken - 1);
}

/// Where the phases of the next step are to be told.
std::optional<PhaseRecorder> RunSession::State::recorder(const Tape::Taken& seen,
                                                         const LazyLocalMap& local_map) const {
  if (!tracing) return std::nullopt;
  Snapshot before;
  if (newest) {
    before = *newest;
    before.phases = nullptr;
  } else {
    before.report.pose = *drawing.start;
    before.map = Lazy<Map>(refinedMap());
  }
  fillSeen(before, seen, readsLocalMap() ? LazyLocalMap() : local_map.again());
  ++before.index;
  return PhaseRecorder(std::move(before));
}

std::shared_ptr<const Snapshot> RunSession::State::snapshot(const Tape::Taken& seen,
                                                            const LazyLocalMap& local_map,
                                                            PhaseRecorder* phases) {
  const Observation& observation = seen.entry.perceived->observation;
  const Pose2 driven = between(source().start_odometry, observation.odometry);
  odometry.push_back({observation.time_s, *drawing.start * driven});

  auto snapshot = std::make_shared<Snapshot>();
  fillSeen(*snapshot, seen, local_map);
  fill(*snapshot);
  snapshot->odometry = odometry.share();
  if (phases != nullptr) {
    auto told = std::make_shared<std::vector<Phase>>(phases->take());
    for (Phase& phase : *told) phase.shown.odometry = snapshot->odometry;
    snapshot->phases = std::move(told);
  }
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
  malloc_trim(0);  // that has taken a lot for a moment
  if (!changed) return nullptr;
  describe(frames.back());
  auto snapshot = std::make_shared<Snapshot>(*newest);
  snapshot->phases = nullptr;
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
  return [make = method->refinedMap(), refinement = refinementJson(settings, source(), frames)] {
    Map map = make();
    map.refinement = refinement;
    return map;
  };
}

Map RunSession::refinedMap() const { return state_->refinedMap()(); }

std::vector<RunWarning> RunSession::warnings() const {
  const RunSettings& settings = state_->settings;
  return runWarnings({state_->counts, source().range_limit_m, state_->drawing,
                      state_->method->refinedMap()(), trajectory(), settings.slam.refine,
                      state_->frames.empty() ? 0.0 : state_->frames.back().unrecognised_m,
                      state_->drawn_start, state_->method->warnings()});
}

std::string RunSession::reportJson() const {
  const double wall_s = millisecondsSince(state_->born) / 1000.0;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const double peak_memory_mb = static_cast<double>(usage.ru_maxrss) / 1024.0;
  return runReportJson({state_->settings, source(), state_->frames, state_->skipped, warnings(),
                        state_->method->refinedMap()(), wall_s, peak_memory_mb});
}

}  // namespace handmap
