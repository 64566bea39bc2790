#include "core/estimation/estimator.h"

#include <cmath>
#include <limits>
#include <utility>

#include "core/estimation/constants.h"
#include "core/estimation/estimator_state.h"

namespace handmap {

using namespace estimation;

HandmapEstimator::HandmapEstimator(const Map& drawing, const EstimatorOptions& options,
                                   std::uint64_t seed) {
  requireReadyToRun(drawing);
  EstimatorOptions stated = options;
  stated.assignment = withStated(drawing.whole, options.assignment);
  if (const auto& start = drawing.start_uncertainty) {
    stated.assignment = withStart(*start, stated.assignment);
  }
  state_ = std::make_unique<State>(drawing, stated, seed);
  state_->pose = *drawing.start;
  state_->correction.correctAll({}, state_->hasPassed());
}

HandmapEstimator::~HandmapEstimator() = default;

void HandmapEstimator::startFrom(const Odometry& odometry) {
  state_->addFrame(0.0, odometry, *state_->drawing.start, Scan{});
}

void HandmapEstimator::reviseOdometry(const std::vector<Pose2>& odometry, double noise) {
  State& state = *state_;
  state.workToTheEnd({});
  state.odometry_noise = noise;
  std::vector<Pose2> before;
  for (const Frame& frame : state.frames) before.push_back(frame.pose);
  state.layAlong(odometry);
  state.carryAlong(before);
  state.evidence.reinsertAll();
  if (state.frames.empty()) return;
  state.pose = state.frames.back().pose;
  state.first_moved = 0;
  state.updateTrajectory();
}

void HandmapEstimator::step(double time_s, const Odometry& odometry, const Scan& scan,
                            const std::stop_token& stop,
                            const std::function<void(double)>& progress) {
  State& state = *state_;
  if (state.frames.empty()) startFrom(odometry);
  const Frame& last = state.frames.back();
  const Pose2 motion = between(last.odometry, odometry.pose);
  const bool moved = std::hypot(motion.x, motion.y) >= odometry::kKeyframe_m ||
                     std::abs(motion.heading) >= odometry::kKeyframeTurn ||
                     mayBeFar(guessedOf({last.odometry, last.guessed}, odometry));
  if (moved) state.workToTheEnd(stop);
  state.pose = last.pose * state.smoother.scaled(motion);
  if (!moved && state.observations.empty()) {
    state.frames.pop_back();
  } else if (!moved) {
    state.addObservation(time_s, motion);
    state.reached(EstimatorPhase::Way);
    state.between_frames = true;
    if (state.due == State::Due::Nothing) return;
    state.workOn(stop, progress);
    state.pose = state.newestPose();
    state.updateTrajectory();
    return;
  }
  state.addFrame(time_s, odometry, state.pose, scan);
  state.addObservation(time_s, Pose2{});
  state.reached(EstimatorPhase::Way);
  state.smoothWindow();
  state.process(stop, progress);
  state.between_frames = false;
  state.pose = state.frames.back().pose;
  state.updateTrajectory();
}

/// What the newest key frame tells. Where observations come oftener than key frames the next ones
/// do a part of it. Once a stop is requested all that can wait is left out: no frame is needed for
/// the next one to be processed.
void HandmapEstimator::State::process(const std::stop_token& stop,
                                      const std::function<void(double)>& progress) {
  reached(EstimatorPhase::Poses);
  odometry_estimate.add(frames);
  smoother.setHeadingVariance(odometry_estimate.headingVariance());
  if (progress) progress(0.4);
  if (stop.stop_requested()) return;
  evidence.add(frames.back());
  updateDirections();
  if (stop.stop_requested()) return;
  reached(EstimatorPhase::Evidence);
  due = Due::Buildings;
  if (!between_frames) workToTheEnd(stop, progress);
}

/// A part of what is due: an observation does one, so that none takes long, and all are done before
/// the next key frame.
void HandmapEstimator::State::workOn(const std::stop_token& stop,
                                     const std::function<void(double)>& progress) {
  const Due part = std::exchange(due, Due::Nothing);
  if (part == Due::Nothing || stop.stop_requested()) return;
  if (part == Due::Buildings) {
    const bool looked_for_new_ones = findBuildings();
    followBuildings();
    reached(EstimatorPhase::Detection);
    if (!stop.stop_requested()) updateNoise();
    if (progress) progress(0.9);
    // They are labelled by their places among those that were found.
    if (looked_for_new_ones) labelBuildings(nearM());
    reached(EstimatorPhase::Labels);
    due = Due::Whole;
    return;
  }
  if (closeLoop(stop) || smoothPeriodically(stop)) labelBuildings(nearM());
  if (stop.stop_requested()) return;
  correction.correctSome(found, hasPassed());
  reached(EstimatorPhase::Correction);
}

void HandmapEstimator::State::workToTheEnd(const std::stop_token& stop,
                                           const std::function<void(double)>& progress) {
  while (due != Due::Nothing) workOn(stop, progress);
}

void HandmapEstimator::finish(const std::stop_token& stop) {
  State& state = *state_;
  if (state.frames.empty()) return;
  state.workToTheEnd(stop);
  state.smoothToTheEnd(stop);
  state.updateTrajectory();
  if (stop.stop_requested()) return;
  std::vector<FoundBox> all = state.allFound();
  if (const auto covariance = state.smoother.covariances(all)) state.covariance = *covariance;
  const std::vector<Frame*> frames = state.framesFrom(state.firstKept());
  for (FoundBox& found : all) {
    if (stop.stop_requested()) return;
    state.finder.locateUnseen(found, {frames.begin(), frames.end()}, state.sensor);
  }
  state.setAllFound(all);
  const bool few = state.labels.settledCount() + state.found.size() <= kMostLabelled &&
                   state.drawing.buildings.size() <= 2 * kMostLabelled;
  state.labelBuildings(few ? std::numeric_limits<double>::infinity() : state.nearM());
  state.correction.correctAll(state.found, state.hasPassed());
  state.pose = state.frames.back().pose;
}

}  // namespace handmap
