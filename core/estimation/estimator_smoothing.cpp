// The last poses smoothed with each key frame, all poses now and then, loops closed.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/estimation/estimator_state.h"
#include "core/estimation/loops/loop_closure.h"

namespace handmap {

namespace {

// Slacks across walls, metres, one after the other: wide to catch, narrow to settle. Choices.
constexpr double kWindowSlacks[] = {0.3, 0.1};
constexpr double kLoopSlacks[] = {0.5, 0.1};
constexpr double kPeriodicSlacks[] = {0.1};
constexpr double kFinalSlacks[] = {0.2, 0.1, 0.03};

constexpr int kMostIterations = 10;       // with one slack; choice
constexpr int kPeriodicIterations = 3;    // now and then; choice
constexpr double kSettled_m = 0.02;       // choice: no pose moves any more
constexpr std::size_t kLeastPeriod = 25;  // key frames; choice: two windows
constexpr std::size_t kPeriodShare = 8;  // of the run so far; choice: an observation costs the same
constexpr std::size_t kMostSmoothed = 300;  // of the buildings settled far away; choice

// Drift of a trajectory that buildings in sight hold, one σ. Choices.
constexpr double kShiftPerMetre = 0.01;
constexpr double kLeastShift_m = 1.0;
constexpr double kTurnPerMetre = 0.0001;  // radians
constexpr double kLeastTurn = 0.03;       // radians

}  // namespace

void HandmapEstimator::State::smoothWindow() {
  std::vector<FoundBox> boxes;
  for (FoundBox& box : found) {
    if (!isInSight(box)) continue;
    box.last_frame = frames.back().number;
    boxes.push_back(box);
  }
  const std::vector<Frame*> active = framesFrom(firstActive());
  const auto count = static_cast<std::size_t>(options.window);
  const std::size_t fixed = active.size() > count ? active.size() - count : 1;
  first_moved = std::min(first_moved, frames.size() - (active.size() - fixed));
  const SmoothingGraph graph{active, fixed, boxes, landmarks.positions()};
  for (const double slack : kWindowSlacks) smoother.iterate(graph, slack);
  if (const auto since = smoother.covariances(boxes)) {
    carryCovariance(frames.size() - active.size() + fixed - 1, *since);
  }
  for (const FoundBox& box : boxes) *findBox(found, box.id) = box;
}

/// The window alone drifts. The longer the run the more seldom, so that a frame costs the same; an
/// iteration with each of a few key frames, so that none takes long.
bool HandmapEstimator::State::smoothPeriodically(const std::stop_token& stop) {
  if (stop.stop_requested()) return false;
  if (frames.size() >= smoothed_at + std::max(kLeastPeriod, smoothed_at / kPeriodShare)) {
    iterations_due = kPeriodicIterations;
  }
  if (iterations_due == 0) return false;
  --iterations_due;
  smoothAll(kPeriodicSlacks, 1, {}, stop);
  return true;
}

void HandmapEstimator::State::smoothToTheEnd(const std::stop_token& stop) {
  smoothAll(kFinalSlacks, kMostIterations, {}, stop);
}

/// All poses and boxes together, with each slack until nothing moves any more or so many times.
/// `same`: of `found`.
void HandmapEstimator::State::smoothAll(std::span<const double> slacks, int iterations,
                                        std::span<const SameBuilding> same,
                                        const std::stop_token& stop) {
  std::vector<FoundBox> all = allFound();
  const std::vector<Frame*> kept = framesFrom(firstKept());
  DrawingPrior prior = labels.prior(kMostSmoothed, found);
  const SmoothingGraph graph{kept, 1, all, landmarks.positions(), same, &prior};
  for (const double slack : slacks) {
    for (int i = 0; i < iterations; ++i) {
      if (stop.stop_requested() || smoother.iterate(graph, slack, stop) < kSettled_m) break;
    }
  }
  smoothed_at = frames.size();
  if (!stop.stop_requested()) renewCovariance();
  first_moved = 0;
  setAllFound(all);
}

/// What is settled far away, then what is found.
std::vector<FoundBox> HandmapEstimator::State::allFound() const {
  std::vector<FoundBox> all = labels.settled(kMostSmoothed);
  all.insert(all.end(), found.begin(), found.end());
  return all;
}

void HandmapEstimator::State::setAllFound(const std::vector<FoundBox>& all) {
  const auto first = all.end() - static_cast<std::ptrdiff_t>(found.size());
  labels.setSettled({all.begin(), first});
  found.assign(first, all.end());
}

/// Where the trajectory has come back to what is dormant: finds out how far it has drifted. Returns
/// whether it did; the labels are then to be found anew.
bool HandmapEstimator::State::closeLoop(const std::stop_token& stop) {
  if (stop.stop_requested()) return false;
  const Vec2 here = frames.back().pose.position();
  const std::optional<DriftPrior> drift = possibleDrift();
  std::vector<FoundBox> again;
  for (const FoundBox& box : found) {
    if (isInSight(box)) again.push_back(box);
  }
  if (!drift || again.size() < 2) return false;
  const auto drawn_of = labels.recognise(again, here, drift->shift_m);
  std::vector<SameBuilding> candidates;
  for (const FoundBox& old : found) {
    const auto drawn = labels.drawnOf(old.id);
    if (!old.dormant || !drawn) continue;
    for (std::size_t i = 0; i < again.size(); ++i) {
      if (drawn_of[i] == drawn) candidates.push_back({old.id, again[i].id});
    }
  }
  const auto pairs = handmap::closeLoop(found, candidates, *drift);
  if (!pairs) return false;
  smoothAll(kLoopSlacks, kMostIterations, *pairs, stop);
  found = merged(found, *pairs);
  evidence.reinsertAll(stop);
  return true;
}

/// Since the dormant buildings that the robot may be near were seen; nullopt where there are none.
std::optional<DriftPrior> HandmapEstimator::State::possibleDrift() const {
  const Frame& here = frames.back();
  DriftPrior drift{here.pose.position(), 0.0, 0.0};
  for (const FoundBox& box : found) {
    if (!box.dormant) continue;
    const double driven = here.driven_m - frames[box.last_frame].driven_m;
    const double shift = kLeastShift_m + kShiftPerMetre * driven;
    const double distance = (box.box.rectangle().centre - drift.here).norm();
    if (distance > options.range_limit_m + 2.0 * shift) continue;
    drift.shift_m = std::max(drift.shift_m, shift);
    drift.turn = std::max(drift.turn, kLeastTurn + kTurnPerMetre * driven);
  }
  if (drift.shift_m == 0.0) return std::nullopt;
  return drift;
}

}  // namespace handmap
