// The last poses smoothed with each key frame, all poses now and then, loops closed.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/estimation/constants.h"
#include "core/estimation/estimator_state.h"
#include "core/estimation/loops/loop_closure.h"

namespace handmap {

using namespace estimation;

void HandmapEstimator::State::smoothWindow() {
  std::vector<FoundBox> boxes;
  for (FoundBox& box : found) {
    if (!isInSight(box)) continue;
    box.last_frame = frames.back().number;
    boxes.push_back(box);
  }
  const std::vector<Frame*> active = framesFrom(firstActive());
  const std::size_t fixed = active.size() > kWindow ? active.size() - kWindow : 1;
  first_moved = std::min(first_moved, frames.size() - (active.size() - fixed));
  const SmoothingGraph graph{active, fixed, boxes, landmarks.positions()};
  for (const double slack : kWindowSlacks_m) smoother.iterate(graph, slack);
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
  smoothAll(kPeriodicSlacks_m, 1, {}, stop);
  return true;
}

void HandmapEstimator::State::smoothToTheEnd(const std::stop_token& stop) {
  smoothAll(kFinalSlacks_m, kMostIterations, {}, stop);
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
  smoothAll(kLoopSlacks_m, 1, *pairs, stop);
  found = merged(found, *pairs);
  iterations_due = kPeriodicIterations;
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
