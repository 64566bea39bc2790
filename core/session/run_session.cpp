#include "core/session/run_session.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <tbb/task_arena.h>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/localization/fastslam_psom.h"
#include "core/session/run_report.h"

namespace handmap {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

std::array<double, 3> spreadOf(const std::vector<Particle>& particles) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  const double heading = particles.front().pose.heading;
  const auto vectorOf = [heading](const Pose2& pose) {
    return Eigen::Vector3d(pose.x, pose.y, normalizedAngle(pose.heading - heading));
  };
  for (const Particle& particle : particles) mean += particle.weight * vectorOf(particle.pose);
  Eigen::Vector3d variance = Eigen::Vector3d::Zero();
  for (const Particle& particle : particles) {
    variance += particle.weight * (vectorOf(particle.pose) - mean).cwiseAbs2();
  }
  return {std::sqrt(variance.x()), std::sqrt(variance.y()), std::sqrt(variance.z())};
}

std::optional<Pose2> poseAt(const std::vector<StampedPose>& poses, double time_s) {
  const auto same = std::lower_bound(
      poses.begin(), poses.end(), time_s,
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
        slam(drawing, source->info().start_odometry, settings.slam, settings.seed),
        arena(settings.threads > 0 ? settings.threads : tbb::task_arena::automatic) {}

  std::optional<Observation> nextReadable();
  std::optional<Percept> perceive(const Observation& observation);
  std::shared_ptr<const Snapshot> snapshot(const Observation& observation, Percept percept);

  Map drawing;
  std::unique_ptr<ObservationSource> source;
  RunSettings settings;
  Perception perception;
  FastSlamPsom slam;
  tbb::task_arena arena;
  std::vector<StampedPose> odometry;  ///< alone, from the drawing's start
  std::vector<FrameReport> frames;
  std::vector<SkippedFrame> skipped;
  Clock::time_point begin = Clock::now();
};

RunSession::RunSession(Map drawing, std::unique_ptr<ObservationSource> source,
                       RunSettings settings)
    : state_(std::make_unique<State>(std::move(drawing), std::move(source), settings)) {}

RunSession::~RunSession() = default;

const SourceInfo& RunSession::source() const { return state_->source->info(); }
const std::vector<SkippedFrame>& RunSession::skipped() const { return state_->skipped; }
const std::vector<FrameReport>& RunSession::frames() const { return state_->frames; }

std::optional<Observation> RunSession::State::nextReadable() {
  for (;;) {
    try {
      return source->next();
    } catch (const FrameError& error) {
      skipped.push_back({error.frame(), error.what()});
    }
  }
}

std::optional<Percept> RunSession::State::perceive(const Observation& observation) {
  try {
    return perception(observation);
  } catch (const Error& error) {
    skipped.push_back({observation.frame, error.what()});
    return std::nullopt;
  }
}

std::shared_ptr<const Snapshot> RunSession::step(std::stop_token stop,
                                                 const std::function<void(double)>& progress) {
  State& state = *state_;
  while (!stop.stop_requested()) {
    const auto begin = Clock::now();
    const std::optional<Observation> observation = state.nextReadable();
    if (!observation) {
      if (!state.frames.empty()) return nullptr;
      throw Error(ErrorCode::RunFailed,
                  fmt::format("none of {} observations could be used{}{}",
                              source().observations, state.skipped.empty() ? "" : "; the first: ",
                              state.skipped.empty() ? "" : state.skipped.front().reason));
    }
    std::optional<Percept> percept = state.perceive(*observation);
    if (!percept) continue;

    FrameReport report;
    report.ms.read = observation->read_ms;
    report.ms.stereo = percept->stereo_ms;
    report.ms.classify = percept->classify_ms;
    report.ms.local_map = percept->local_map_ms;
    const auto slam_begin = Clock::now();
    bool done = false;
    state.arena.execute([&] {
      done = state.slam.step(observation->time_s, observation->odometry, percept->local_map, stop,
                             progress);
    });
    if (!done) return nullptr;
    report.ms.slam = millisecondsSince(slam_begin);
    report.ms.total = millisecondsSince(begin);
    report.frame = observation->frame;
    report.time_s = observation->time_s;
    report.effective_sample_size = state.slam.lastStep().effective_sample_size;
    report.visible_buildings = state.slam.lastStep().visible_buildings;
    report.pose = state.slam.best().pose;
    report.pose_sigma = spreadOf(state.slam.particles());
    state.frames.push_back(report);
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
  snapshot->report = frames.back();
  snapshot->particles.reserve(slam.particles().size());
  for (const Particle& particle : slam.particles()) {
    snapshot->particles.push_back({particle.pose, particle.weight});
  }
  snapshot->map = slam.refinedMap();
  snapshot->trajectory =
      std::make_shared<const std::vector<StampedPose>>(slam.best().path.poses());
  snapshot->odometry = std::make_shared<const std::vector<StampedPose>>(odometry);
  snapshot->truth = poseAt(source->info().truth, observation.time_s);
  snapshot->local_map = std::make_shared<const LocalMap>(std::move(percept.local_map));
  snapshot->image = percept.image;
  snapshot->disparity = percept.disparity;
  return snapshot;
}

std::vector<StampedPose> RunSession::trajectory() const { return state_->slam.best().path.poses(); }

Map RunSession::refinedMap() const {
  Map map = state_->slam.refinedMap();
  map.refinement = refinementJson(state_->settings, source(), state_->frames);
  return map;
}

std::string RunSession::reportJson() const {
  const double wall_s = millisecondsSince(state_->begin) / 1000.0;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const double peak_memory_mb = static_cast<double>(usage.ru_maxrss) / 1024.0;
  return runReportJson(state_->settings, source(), state_->frames, state_->skipped, wall_s,
                       peak_memory_mb);
}

}  // namespace handmap
