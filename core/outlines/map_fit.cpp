#include "core/outlines/map_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/parallel.h"
#include "core/map/certainty.h"

namespace handmap {

namespace {

constexpr double kLeastEvidence = 10.0;  // nats
constexpr double kLeastGain = 3.0;
constexpr std::size_t kMostRivals = 3;
constexpr double kOwnedWithin_m = 0.5;
constexpr double kOverlap = 400.0;  // nats for all of a building on another
// How people draw what they know: sizes, turns, skews and single walls are off by no more, one σ,
// however uncertain the drawing says it is; and by so much however certain.
constexpr double kMostScale = 0.3;
constexpr double kMostTurn = 0.08;
constexpr double kMostShear = 0.03;
constexpr double kMostCorner_m = 1.0;
constexpr double kLeastShare = 0.01;
constexpr double kFitSlack_m = 0.15;

double sizeOf(const Polygon& outline) {
  const Bounds bounds = boundsOf(outline);
  return (bounds.high - bounds.low).norm();
}

double headingOf(const Polygon& outline) {
  double longest = 0.0;
  Vec2 along(1.0, 0.0);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 wall = outline[i] - outline[(i + outline.size() - 1) % outline.size()];
    if (wall.norm() <= longest) continue;
    longest = wall.norm();
    along = wall;
  }
  return std::atan2(along.y(), along.x());
}

OutlinePrior priorOf(const OutlineTask& task) {
  OutlinePrior prior;
  prior.start = task.start;
  prior.heading = headingOf(task.start);
  const Rectangle now = boundingRectangle(task.start, prior.heading);
  // What is longest may have become another side.
  const double turn = std::remainder(headingOf(task.drawn) - prior.heading, kPi / 2.0);
  const Rectangle drawn = boundingRectangle(task.drawn, prior.heading + turn);
  prior.expected_log_size = {std::log(drawn.width / now.width), std::log(drawn.depth / now.depth)};
  prior.shift_m = task.shift_m;
  const double share = task.size_m / std::sqrt(drawn.width * drawn.depth);
  prior.log_scale =
      std::clamp(std::hypot(share, task.whole.scale.value_or(0.0)), kLeastShare, kMostScale);
  prior.turn = std::clamp(std::hypot(share, task.whole.turn.value_or(0.0)), kLeastShare, kMostTurn);
  prior.shear = task.rectangle ? 0.0 : std::clamp(share, kLeastShare, kMostShear);
  prior.corner_m = task.rectangle ? 0.0 : std::min(task.size_m, kMostCorner_m);
  return prior;
}

double sharedArea(const Polygon& outline, const Polygon& other) {
  return boundsOf(outline).overlaps(boundsOf(other)) ? intersectionArea(outline, other) : 0.0;
}

double priorShift(const OutlineTask& task) {
  return std::hypot(task.drawn_shift_m, 0.5 * task.size_m);
}

/// As the box() of a building of this outline has them.
Sides sidesOf(const Polygon& outline, const OutlineTask& task, const OutlineScorer& scorer) {
  const Vec2 first = outline[1] - outline[0];
  const double heading =
      task.rectangle ? std::atan2(first.y(), first.x()) : principalHeading(outline);
  Sides sides;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const Vec2 normal = unitVector(heading + static_cast<double>(k) * kPi / 2.0);
    sides[k].sigma = spreadOfSide(outline, normal, priorShift(task), scorer);
  }
  const std::vector<double> returns = scorer.returnsOf(outline, kFitSlack_m);
  std::array<double, 4> of_side{};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 along = outline[i] - outline[(i + outline.size() - 1) % outline.size()];
    of_side[sideFacing(heading, -perpendicular(along))] += returns[i];
  }
  for (std::size_t k = 0; k < sides.size(); ++k) sides[k].seen = of_side[k] >= kSeenReturns;
  return sides;
}

Estimate estimateOf(const Polygon& outline, const OutlineTask& task, const OutlineScorer& scorer) {
  const double prior = priorShift(task);
  const auto across = [&](const Vec2& direction) {
    return std::hypot(spreadOfSide(outline, direction, prior, scorer),
                      spreadOfSide(outline, -direction, prior, scorer));
  };
  return {0.5 * across({1.0, 0.0}), 0.5 * across({0.0, 1.0}),
          std::min(across(unitVector(headingOf(outline))), task.size_m),
          scorer.framesStandingFor(outline, kOwnedWithin_m)};
}

/// The work on all buildings, and what of it is settled.
class Fitting {
 public:
  Fitting(const std::vector<OutlineTask>& tasks, const PlacedRays& placed, double range_limit_m,
          std::uint64_t seed, std::stop_token stop)
      : tasks_(tasks),
        placed_(placed),
        range_limit_m_(range_limit_m),
        seed_(seed),
        stop_(std::move(stop)),
        owners_(placed.rays.size(), kNobody),
        settled_(tasks.size()),
        worth_(tasks.size()) {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      priors_.push_back(priorOf(tasks[i]));
      if (stop_.stop_requested()) continue;
      if (tasks[i].labelled) own(i, tasks[i].start, scorerFor(i));
    }
  }

  FittedOutline search(std::size_t i) const {
    return searchOutline(priors_[i], scorerFor(i),
                         RandomStream(seed_, static_cast<std::uint32_t>(i)), stop_);
  }

  /// After the surer ones. `first`: where it was found before these were settled.
  OutlineResult settle(std::size_t i, const FittedOutline& first) {
    const OutlineTask& task = tasks_[i];
    const OutlineScorer scorer = scorerFor(i);
    const FittedOutline fitted = isDisturbed(first.outline, task) ? search(i) : first;
    if (stop_.stop_requested()) return {};
    OutlineResult result;
    result.evidence = fitted.score - kOverlap * overlap(i, fitted.outline);
    const double drawn = scorer(task.drawn, kFitSlack_m) - kOverlap * overlap(i, task.drawn);
    const double start = scorer(task.start, kFitSlack_m) - kOverlap * overlap(i, task.start);
    result.gain = result.evidence + fitted.prior - drawn;
    if (result.evidence > kLeastEvidence && result.gain > kLeastGain) {
      result.verdict = Verdict::Moved;
      result.outline = fitted.outline;
      worth_[i] = result.evidence + fitted.prior;
    } else {
      result.outline = start >= drawn ? task.start : task.drawn;
      worth_[i] = std::max({start, drawn, 0.0});
    }
    letGo(i);
    if (result.verdict == Verdict::Moved || std::max(start, drawn) > kLeastEvidence) {
      result.estimate = estimateOf(result.outline, task, scorer);
      result.sides = sidesOf(result.outline, task, scorer);
      own(i, result.outline, scorer);
      settled_[i] = result.outline;
    }
    return result;
  }

  /// A building of which the rays tell more than of what was left of them has lost its walls to
  /// surer neighbours: whether all together are worth more where it chooses before them.
  void settleAgain(std::size_t i, const FittedOutline& first, std::vector<OutlineResult>& results) {
    if (results[i].verdict == Verdict::Moved || first.score < kLeastEvidence) return;
    std::vector<std::size_t> group;
    for (std::size_t k = 0; k < settled_.size(); ++k) {
      if (k != i && settled_[k] && sharedArea(first.outline, *settled_[k]) > 0.0)
        group.push_back(k);
    }
    if (group.empty() || group.size() > kMostRivals) return;
    const Fitting before = *this;
    const std::vector<OutlineResult> results_before = results;
    group.insert(group.begin(), i);
    for (const std::size_t k : group) letGo(k);
    for (const std::size_t k : group) {
      results[k] = settle(k, search(k));
      if (stop_.stop_requested()) return;
    }
    double gain = -kLeastGain;
    for (const std::size_t k : group) gain += worth_[k] - before.worth_[k];
    if (gain > 0.0) return;
    owners_ = before.owners_;
    settled_ = before.settled_;
    worth_ = before.worth_;
    results = results_before;
  }

 private:
  /// Share of the area that settled ones have.
  double overlap(std::size_t i, const Polygon& outline) const {
    double shared = 0.0;
    for (std::size_t k = 0; k < settled_.size(); ++k) {
      if (k != i && settled_[k]) shared += sharedArea(outline, *settled_[k]);
    }
    return shared / std::max(1.0, std::abs(signedArea(outline)));
  }
  void letGo(std::size_t i) {
    std::replace(owners_.begin(), owners_.end(), static_cast<int>(i), kNobody);
    settled_[i].reset();
  }
  OutlineScorer scorerFor(std::size_t i) const {
    const Bounds bounds = boundsOf(tasks_[i].start);
    const double radius = 0.5 * (bounds.high - bounds.low).norm();
    return {placed_,
            range_limit_m_,
            owners_,
            static_cast<int>(i),
            0.5 * (bounds.low + bounds.high),
            1.4 * radius + 2.5 * priors_[i].shift_m};
  }
  void own(std::size_t i, const Polygon& outline, const OutlineScorer& scorer) {
    for (const std::size_t ray : scorer.standingFor(outline, kOwnedWithin_m)) {
      owners_[ray] = static_cast<int>(i);
    }
  }
  bool isDisturbed(const Polygon& outline, const OutlineTask& task) const {
    return std::any_of(settled_.begin(), settled_.end(), [&](const auto& other) {
      return other && distanceTo(*other, centroid(outline)) < sizeOf(task.drawn);
    });
  }

  const std::vector<OutlineTask>& tasks_;
  const PlacedRays& placed_;
  double range_limit_m_;
  std::uint64_t seed_;
  std::stop_token stop_;
  RayOwners owners_;
  std::vector<OutlinePrior> priors_;
  std::vector<std::optional<Polygon>> settled_;
  std::vector<double> worth_;  ///< nats, of what is settled
};

}  // namespace

std::vector<OutlineResult> fitOutlines(const std::vector<OutlineTask>& tasks,
                                       const PlacedRays& placed, double range_limit_m,
                                       std::uint64_t seed, const std::stop_token& stop,
                                       const std::function<void(double)>& progress) {
  Fitting fitting(tasks, placed, range_limit_m, seed, stop);
  std::vector<FittedOutline> first(tasks.size());
  parallelFor(tasks.size(), [&](std::size_t i) {
    if (!stop.stop_requested()) first[i] = fitting.search(i);
  });
  if (stop.stop_requested()) return {};
  if (progress) progress(0.5);

  // The surest first: what it stands for is no longer there for the others.
  std::vector<std::size_t> order(tasks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return first[a].total() > first[b].total();
  });
  std::vector<OutlineResult> results(tasks.size());
  std::size_t done = 0;
  for (const std::size_t i : order) {
    results[i] = fitting.settle(i, first[i]);
    if (stop.stop_requested()) return {};
    const double share = static_cast<double>(++done) / static_cast<double>(tasks.size());
    if (progress) progress(0.5 + 0.5 * share);
  }
  for (const std::size_t i : order) {
    fitting.settleAgain(i, first[i], results);
    if (stop.stop_requested()) return {};
  }
  return results;
}

}  // namespace handmap
