#include "core/outlines/map_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/map/certainty.h"
#include "core/outlines/constants.h"
#include "core/outlines/joint_places.h"
#include "core/outlines/terraces.h"

namespace handmap {

using namespace outlines;

namespace {

double sizeOf(const Polygon& outline) {
  const Bounds bounds = boundsOf(outline);
  return (bounds.high - bounds.low).norm();
}

/// A size that is out of its range is that of another thing.
bool startMayBe(const OutlinePrior& prior) {
  return (prior.expected_log_size.array().abs() <= kMostSizeOff).all();
}

double priorShift(const OutlineTask& task) {
  return std::hypot(task.drawn_shift_m, 0.5 * task.size_m);
}

/// How far a side may be off, one σ: the row tells that where a house ends in it, else the returns.
class SpreadAlong {
 public:
  SpreadAlong(const Polygon& outline, double prior_m, const OutlineScorer& scorer,
              const std::optional<RowPlace>& in_row)
      : outline_(outline),
        prior_m_(prior_m),
        scorer_(scorer),
        in_row_(in_row.value_or(RowPlace{})) {}
  double operator()(const Vec2& direction) const {
    const double along = direction.dot(in_row_.along);
    const double end = along > 0.0 ? in_row_.to_sigma : in_row_.from_sigma;
    if (std::abs(along) > std::sqrt(0.5) && end > 0.0) return std::hypot(end, kSlack_m);
    return spreadOfSide(outline_, direction, prior_m_, scorer_);
  }

 private:
  const Polygon& outline_;
  double prior_m_;
  const OutlineScorer& scorer_;
  RowPlace in_row_;
};

/// As the box() of a building of this outline has them.
Sides sidesOf(const Polygon& outline, const OutlineTask& task, const OutlineScorer& scorer,
              const SpreadAlong& spread) {
  const Vec2 first = outline[1] - outline[0];
  const double heading =
      task.rectangle ? std::atan2(first.y(), first.x()) : principalHeading(outline);
  Sides sides;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const Vec2 normal = unitVector(heading + static_cast<double>(k) * kPi / 2.0);
    sides[k].sigma = spread(normal);
  }
  const auto of_side = scorer.returnsOfSides(outline, heading, kSlack_m);
  for (std::size_t k = 0; k < sides.size(); ++k) sides[k].seen = of_side[k] >= kSeenReturns;
  return sides;
}

Estimate estimateOf(const Polygon& outline, const OutlineTask& task, const OutlineScorer& scorer,
                    const SpreadAlong& spread) {
  const auto across = [&](const Vec2& direction) {
    return std::hypot(spread(direction), spread(-direction));
  };
  return {0.5 * across({1.0, 0.0}), 0.5 * across({0.0, 1.0}),
          std::min(across(unitVector(headingOf(outline))), task.size_m),
          scorer.framesStandingFor(outline, kOwnedWithin_m)};
}

/// The buildings one after the other, each beside all others.
class Settling {
 public:
  Settling(const std::vector<OutlineTask>& tasks, const PlacedRays& placed, double range_limit_m,
           std::uint64_t seed, std::stop_token stop)
      : tasks_(tasks),
        placed_(placed),
        range_limit_m_(range_limit_m),
        seed_(seed),
        stop_(std::move(stop)),
        owners_(placed.rays.size(), kNobody),
        in_row_(tasks.size()),
        settled_(tasks.size()) {
    for (const OutlineTask& task : tasks) priors_.push_back(priorOf(task));
  }

  /// Where they are, as far as they do not disturb each other. Returns their order: the surest
  /// first, those last that have no place.
  std::vector<std::size_t> begin() {
    for (std::size_t i = 0; i < tasks_.size() && !stop_.stop_requested(); ++i) {
      if (tasks_[i].labelled) own(i, tasks_[i].start, scorerOf(i));
    }
    places_ = placesTogether(priors_, placed_, range_limit_m_, owners_, seed_, stop_);
    std::ranges::fill(owners_, kNobody);
    std::ranges::fill(settled_, std::nullopt);
    for (auto& [b, prior, place, in_row] :
         dividedTerraces(tasks_, places_, placed_, range_limit_m_, stop_)) {
      priors_[b] = std::move(prior);
      places_[b] = std::move(place);
      if (places_[b]) in_row_[b] = in_row;
    }
    std::vector<std::size_t> order(tasks_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::ranges::greater{},
                             [&](std::size_t i) { return places_[i] ? places_[i]->total() : 0.0; });
    for (const std::size_t i : order) {
      if (places_[i]) own(i, places_[i]->outline, scorerOf(i));
    }
    return order;
  }

  OutlineResult settle(std::size_t i) {
    const OutlineTask& task = tasks_[i];
    letGo(i);
    const OutlineScorer scorer = scorerOf(i);
    const FittedOutline fitted = fittedBesideOthers(i, scorer);
    if (stop_.stop_requested()) return {};
    OutlineResult result;
    result.evidence = fitted.score - kOverlap * overlap(i, fitted.outline);
    const double drawn = scorer(task.drawn, kSlack_m) - kOverlap * overlap(i, task.drawn);
    const double start = scorer(task.start, kSlack_m) - kOverlap * overlap(i, task.start);
    result.gain = result.evidence + fitted.prior - drawn;
    if (result.evidence > kLeastEvidence && result.gain > kTells) {
      result.verdict = Verdict::Moved;
      result.outline = fitted.outline;
      if (in_row_[i]) result.doubt = in_row_[i]->doubt;
    } else {
      const bool at_start = start >= drawn && startMayBe(priors_[i]);
      result.outline = at_start ? task.start : task.drawn;
    }
    if (result.verdict == Verdict::Moved || std::max(start, drawn) > kLeastEvidence) {
      const SpreadAlong spread(result.outline, priorShift(task), scorer, in_row_[i]);
      result.estimate = estimateOf(result.outline, task, scorer, spread);
      result.sides = sidesOf(result.outline, task, scorer, spread);
      own(i, result.outline, scorer);
    } else if (scorer(result.outline, kDrawnSlack_m) < -kTells) {
      result.doubt = 1.0;
    }
    return result;
  }

 private:
  FittedOutline fittedBesideOthers(std::size_t i, const OutlineScorer& scorer) const {
    const RandomStream random(seed_, static_cast<std::uint32_t>(i));
    if (places_[i]) {
      if (in_row_[i] || !isDisturbed(i, places_[i]->outline)) return *places_[i];
      return searchNear(places_[i]->move, priors_[i], scorer, random, stop_);
    }
    const auto worth = [&](const FittedOutline& place) {
      return place.total() - kOverlap * overlap(i, place.outline);
    };
    return std::ranges::max(searchOutlines(priors_[i], scorer, random, stop_), {}, worth);
  }

  /// Share of the area that others have.
  double overlap(std::size_t i, const Polygon& outline) const {
    double shared = 0.0;
    for (std::size_t k = 0; k < settled_.size(); ++k) {
      if (k != i && settled_[k]) shared += sharedArea(outline, *settled_[k]);
    }
    return shared / std::max(1.0, std::abs(signedArea(outline)));
  }
  /// With the returns there that nobody has yet.
  void own(std::size_t i, const Polygon& outline, const OutlineScorer& scorer) {
    settled_[i] = outline;
    for (const OutlineScorer::Standing& claim : scorer.standingFor(outline, kOwnedWithin_m)) {
      if (owners_[claim.ray] == kNobody) owners_[claim.ray] = static_cast<int>(i);
    }
  }
  void letGo(std::size_t i) {
    std::replace(owners_.begin(), owners_.end(), static_cast<int>(i), kNobody);
    settled_[i].reset();
  }
  OutlineScorer scorerOf(std::size_t i) const {
    return scorerFor(priors_[i], placed_, range_limit_m_, owners_, static_cast<int>(i));
  }
  bool isDisturbed(std::size_t i, const Polygon& outline) const {
    const double size = sizeOf(tasks_[i].drawn);
    return std::any_of(settled_.begin(), settled_.end(), [&](const auto& other) {
      return other && distanceTo(*other, centroid(outline)) < size;
    });
  }

  const std::vector<OutlineTask>& tasks_;
  const PlacedRays& placed_;
  double range_limit_m_;
  std::uint64_t seed_;
  std::stop_token stop_;
  RayOwners owners_;
  std::vector<OutlinePrior> priors_;
  std::vector<std::optional<FittedOutline>> places_;
  std::vector<std::optional<RowPlace>> in_row_;  ///< of a house of a terrace
  std::vector<std::optional<Polygon>> settled_;
};

}  // namespace

std::vector<OutlineResult> fitOutlines(const std::vector<OutlineTask>& tasks,
                                       const PlacedRays& placed, double range_limit_m,
                                       std::uint64_t seed, const std::stop_token& stop,
                                       const std::function<void(double)>& progress) {
  Settling settling(tasks, placed, range_limit_m, seed, stop);
  const std::vector<std::size_t> order = settling.begin();
  if (stop.stop_requested()) return {};
  if (progress) progress(0.5);
  std::vector<OutlineResult> results(tasks.size());
  std::size_t done = 0;
  for (const std::size_t i : order) {
    results[i] = settling.settle(i);
    if (stop.stop_requested()) return {};
    const double share = static_cast<double>(++done) / static_cast<double>(tasks.size());
    if (progress) progress(0.5 + 0.5 * share);
  }
  return results;
}

}  // namespace handmap
