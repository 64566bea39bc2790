#include "core/outlines/outline_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/outlines/constants.h"
#include "core/outlines/evolution.h"

namespace handmap {

using namespace outlines;

namespace {

using Move = OutlineMove;

class Shape {
 public:
  explicit Shape(const OutlinePrior& prior) : prior_(prior) {
    const Rectangle box = boundingRectangle(prior.start, prior.heading);
    centre_ = box.centre;
    const double longer = 0.5 * std::max(box.width, box.depth);
    levers_ = {1.0, 1.0, longer, 0.5 * box.width, 0.5 * box.depth, longer};
    const Vec2 u = unitVector(prior.heading);
    for (const Vec2& corner : prior.start) {
      own_.emplace_back(u.dot(corner - centre_), perpendicular(u).dot(corner - centre_));
    }
  }

  Polygon operator()(const Move& m) const {
    const Vec2 u = unitVector(prior_.heading + m[2]);
    const Vec2 v = perpendicular(u);
    const Vec2 centre = centre_ + Vec2(m[0], m[1]);
    const double su = std::exp(m[3]);
    const double sv = std::exp(m[4]);
    Polygon outline;
    outline.reserve(own_.size());
    for (const Vec2& p : own_) {
      outline.push_back(centre + (su * p.x() + m[5] * p.y()) * u + sv * p.y() * v);
    }
    return outline;
  }

  double logPrior(const Move& m) const {
    const auto part = [](double value, double sigma) {
      return sigma > 0.0 ? -0.5 * std::pow(value / sigma, 2) : 0.0;
    };
    double beyond = 0.0;
    for (int axis = 0; axis < 2; ++axis) {
      const double size = m[static_cast<std::size_t>(3 + axis)];
      beyond += std::max(0.0, std::abs(size - prior_.expected_log_size[axis]) - kMostSizeOff);
    }
    return -kAnotherThing * beyond + part(m[0], prior_.shift_m) + part(m[1], prior_.shift_m) +
           part(m[2], prior_.turn) + part(m[3] - prior_.expected_log_size.x(), prior_.log_scale) +
           part(m[4] - prior_.expected_log_size.y(), prior_.log_scale) + part(m[5], prior_.shear);
  }

  Move sample(RandomStream& random) const {
    const auto draw = [&](double sigma) {
      double value = random.normal();
      while (std::abs(value) > kWidest) value = random.normal();
      return sigma * value;
    };
    return {draw(prior_.shift_m),
            draw(prior_.shift_m),
            draw(prior_.turn),
            prior_.expected_log_size.x() + draw(prior_.log_scale),
            prior_.expected_log_size.y() + draw(prior_.log_scale),
            draw(prior_.shear)};
  }

  /// Metres at the walls, all of them: so that steps of all matter alike. Without the shear of
  /// what has none.
  Eigen::VectorXd metresOf(const Move& m) const {
    Eigen::VectorXd metres(prior_.shear > 0.0 ? 6 : 5);
    for (Eigen::Index k = 0; k < metres.size(); ++k) {
      const auto i = static_cast<std::size_t>(k);
      metres[k] = m[i] * levers_[i];
    }
    return metres;
  }
  Move moveOf(const Eigen::VectorXd& metres) const {
    Move m{};
    for (Eigen::Index k = 0; k < metres.size(); ++k) {
      const auto i = static_cast<std::size_t>(k);
      m[i] = metres[k] / levers_[i];
    }
    return m;
  }

 private:
  const OutlinePrior& prior_;
  Vec2 centre_;
  Move levers_;
  std::vector<Vec2> own_;  ///< corners along and across the axes
};

FittedOutline placeAt(const Move& move, const Shape& shape, const OutlineScorer& scorer,
                      double slack_m) {
  Polygon outline = shape(move);
  const auto [nats, against] = scorer.evidence(outline, slack_m);
  return {std::move(outline), move, nats, against, shape.logPrior(move)};
}

FittedOutline improved(const Move& from, const Shape& shape, const OutlineScorer& scorer,
                       const Stage& stage, RandomStream& random, const std::stop_token& stop) {
  const auto value = [&](const Eigen::VectorXd& metres) {
    const Move m = shape.moveOf(metres);
    return scorer(shape(m), stage.slack_m) + shape.logPrior(m);
  };
  const Evolved evolved =
      evolve(value, shape.metresOf(from), {.step = stage.step_m, .least_step = stage.least_step_m},
             random, stop);
  return placeAt(shape.moveOf(evolved.parameters), shape, scorer, stage.slack_m);
}

double farthestCorner(const Polygon& a, const Polygon& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

/// Of places that are the same the best alone: half of them by what they explain, half by what that
/// tells of which thing the building is.
void keepBest(std::vector<FittedOutline>& places, std::size_t most) {
  std::vector<FittedOutline> kept;
  const auto keep = [&](std::size_t until, auto worth) {
    std::ranges::stable_sort(places, std::ranges::greater{}, worth);
    for (const FittedOutline& place : places) {
      if (kept.size() >= until) return;
      const bool is_new = std::ranges::none_of(kept, [&](const FittedOutline& better) {
        return farthestCorner(better.outline, place.outline) < kAnother_m;
      });
      if (is_new) kept.push_back(place);
    }
  };
  keep(most / 2, &FittedOutline::total);
  keep(most, [](const FittedOutline& place) { return tellsWhichThing(place) + place.prior; });
  places = std::move(kept);
}

}  // namespace

double tellsWhichThing(const FittedOutline& place, double less) {
  const double seen = place.score - place.against - less;
  return place.against + (seen > 0.0 ? kLeastEvidence * std::log1p(seen / kLeastEvidence) : seen);
}

std::vector<FittedOutline> searchOutlines(const OutlinePrior& prior, const OutlineScorer& scorer,
                                          RandomStream random, const std::stop_token& stop) {
  const Shape shape(prior);
  const OutlineScorer coarse = scorer.thinned(kAsked);
  std::vector<FittedOutline> places;
  for (int i = 0; i <= kSamples; ++i) {
    if (stop.stop_requested()) return {{prior.start}};
    const Move move = i == 0 ? Move{} : shape.sample(random);
    places.push_back(placeAt(move, shape, coarse, kSlackAtFirst_m));
  }
  for (const Stage& stage : kStages) {
    keepBest(places, stage.tries);
    for (FittedOutline& place : places) {
      place = improved(place.move, shape, coarse, stage, random, stop);
      if (stop.stop_requested()) return {{prior.start}};
    }
  }
  // Narrow walls are found near where they are only: the start may be right as it is.
  keepBest(places, kLast.tries);
  places.push_back({prior.start});
  const OutlineScorer fine = scorer.thinned(kAskedLater);
  for (FittedOutline& place : places) {
    place = improved(place.move, shape, fine, kLast, random, stop);
    if (stop.stop_requested()) return {{prior.start}};
  }
  keepBest(places, 2 * places.size());
  return places;
}

FittedOutline searchNear(const OutlineMove& start, const OutlinePrior& prior,
                         const OutlineScorer& scorer, RandomStream random,
                         const std::stop_token& stop) {
  const Shape shape(prior);
  const OutlineScorer fine = scorer.thinned(kAskedLater);
  return improved(start, shape, fine, kLast, random, stop);
}

FittedOutline placedOn(const Rectangle& box, const OutlinePrior& prior) {
  const Shape shape(prior);
  const Rectangle now = boundingRectangle(prior.start, prior.heading);
  const double quarters = std::round((box.heading - prior.heading) / (kPi / 2.0));
  const bool across = std::fmod(std::abs(quarters), 2.0) == 1.0;
  const Vec2 shift = box.centre - now.centre;
  const Move move{shift.x(),
                  shift.y(),
                  box.heading - prior.heading - quarters * kPi / 2.0,
                  std::log((across ? box.depth : box.width) / now.width),
                  std::log((across ? box.width : box.depth) / now.depth),
                  0.0};
  return {shape(move), move, 0.0, 0.0, shape.logPrior(move)};
}

void scorePlace(FittedOutline& place, const OutlineScorer& scorer) {
  const auto [nats, against] = scorer.thinned(kAskedLater).evidence(place.outline, kLast.slack_m);
  place.score = nats;
  place.against = against;
}

double spreadOfSide(const Polygon& outline, const Vec2& direction, double prior_sigma_m,
                    const OutlineScorer& scorer) {
  const OutlineScorer fine = scorer.thinned(kAskedLater);
  double low = outline.front().dot(direction);
  double high = low;
  for (const Vec2& corner : outline) {
    low = std::min(low, corner.dot(direction));
    high = std::max(high, corner.dot(direction));
  }
  const auto value = [&](double by) {
    Polygon moved = outline;
    for (Vec2& corner : moved) {
      corner += (corner.dot(direction) - low) / (high - low) * by * direction;
    }
    return fine(moved, kLast.slack_m) - 0.5 * std::pow(by / prior_sigma_m, 2);
  };
  const double best = value(0.0);
  double sigma = kSpreadFirst_m;
  while (sigma < prior_sigma_m && best - std::max(value(sigma), value(-sigma)) < kSpreadDrop) {
    sigma *= 1.5;
  }
  return std::min(std::hypot(sigma, kSystematic_m), std::max(prior_sigma_m, kSystematic_m));
}

}  // namespace handmap
