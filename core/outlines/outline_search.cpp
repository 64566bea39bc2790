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

struct Candidate {
  Move move{};
  double total = -1e300;
};

void improve(Candidate& candidate, const Shape& shape, const OutlineScorer& scorer,
             const Stage& stage, RandomStream& random, const std::stop_token& stop) {
  const auto value = [&](const Eigen::VectorXd& metres) {
    const Move m = shape.moveOf(metres);
    return scorer(shape(m), stage.slack_m) + shape.logPrior(m);
  };
  const Evolved evolved =
      evolve(value, shape.metresOf(candidate.move),
             {.step = stage.step_m, .least_step = stage.least_step_m}, random, stop);
  candidate = {shape.moveOf(evolved.parameters), evolved.value};
}

double farthestCorner(const Polygon& a, const Polygon& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

/// Of places that are the same the best alone.
void keepBest(std::vector<Candidate>& candidates, std::size_t most, const Shape& shape) {
  std::ranges::stable_sort(candidates, std::ranges::greater{}, &Candidate::total);
  std::vector<Candidate> kept;
  for (const Candidate& candidate : candidates) {
    if (kept.size() == most) break;
    const Polygon outline = shape(candidate.move);
    const bool is_new = std::ranges::none_of(kept, [&](const Candidate& better) {
      return farthestCorner(shape(better.move), outline) < kAnother_m;
    });
    if (is_new) kept.push_back(candidate);
  }
  candidates = std::move(kept);
}

FittedOutline fittedBy(const Move& move, const Shape& shape, const OutlineScorer& scorer) {
  Polygon outline = shape(move);
  const double score = scorer(outline, kLast.slack_m);
  return {std::move(outline), move, score, shape.logPrior(move)};
}

}  // namespace

std::vector<FittedOutline> searchOutlines(const OutlinePrior& prior, const OutlineScorer& scorer,
                                          RandomStream random, const std::stop_token& stop) {
  const Shape shape(prior);
  const OutlineScorer coarse = scorer.thinned(kAsked);
  std::vector<Candidate> candidates(1);
  for (int i = 0; i < kSamples; ++i) candidates.push_back({shape.sample(random)});
  for (Candidate& candidate : candidates) {
    if (stop.stop_requested()) return {{prior.start}};
    candidate.total =
        coarse(shape(candidate.move), kSlackAtFirst_m) + shape.logPrior(candidate.move);
  }
  const Candidate start = candidates.front();
  for (const Stage& stage : kStages) {
    keepBest(candidates, stage.tries, shape);
    for (Candidate& candidate : candidates) {
      improve(candidate, shape, coarse, stage, random, stop);
      if (stop.stop_requested()) return {{prior.start}};
    }
  }
  // Narrow walls are found near where they are only: the start may be right as it is.
  keepBest(candidates, kLast.tries, shape);
  candidates.push_back(start);
  const OutlineScorer fine = scorer.thinned(kAskedLater);
  for (Candidate& candidate : candidates) {
    improve(candidate, shape, fine, kLast, random, stop);
    if (stop.stop_requested()) return {{prior.start}};
  }
  keepBest(candidates, candidates.size(), shape);
  std::vector<FittedOutline> fitted;
  for (const Candidate& best : candidates) fitted.push_back(fittedBy(best.move, shape, fine));
  return fitted;
}

FittedOutline searchNear(const OutlineMove& start, const OutlinePrior& prior,
                         const OutlineScorer& scorer, RandomStream random,
                         const std::stop_token& stop) {
  const Shape shape(prior);
  const OutlineScorer fine = scorer.thinned(kAskedLater);
  Candidate candidate{start};
  improve(candidate, shape, fine, kLast, random, stop);
  return fittedBy(candidate.move, shape, fine);
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
  return {shape(move), move, 0.0, shape.logPrior(move)};
}

void scorePlace(FittedOutline& place, const OutlineScorer& scorer) {
  place.score = scorer.thinned(kAskedLater)(place.outline, kLast.slack_m);
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
