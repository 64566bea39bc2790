#include "core/outlines/outline_search.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handmap {

namespace {

constexpr int kSamples = 1500;
constexpr std::size_t kAsked = 2500;  // rays that samples are weighed by
constexpr std::size_t kAskedLater = 8000;
constexpr double kWidest = 2.5;        // σ
constexpr double kSlackAtFirst = 1.5;  // metres
struct Stage {
  double slack_m;
  std::size_t tries;
  double step_m;
};
constexpr Stage kStages[] = {{0.8, 8, 1.0}, {0.3, 4, 0.5}};
constexpr std::size_t kFinalists = 2;
constexpr double kLastSlack = 0.15;
constexpr double kLastStep = 0.25;
constexpr double kLeastStep = 0.06;

/// Shift, turn, logs of two scales, shear.
using Move = std::array<double, 6>;

class Shape {
 public:
  explicit Shape(const OutlinePrior& prior) : prior_(prior) {
    const Rectangle box = boundingRectangle(prior.start, prior.heading);
    centre_ = box.centre;
    half_ = {0.5 * box.width, 0.5 * box.depth};
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
    return part(m[0], prior_.shift_m) + part(m[1], prior_.shift_m) + part(m[2], prior_.turn) +
           part(m[3] - prior_.expected_log_size.x(), prior_.log_scale) +
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

  /// What a pattern search tries: each part alone, and one side with the other staying. `step_m`
  /// at the walls.
  std::vector<Move> moves(const Move& at, double step_m) const {
    const double size = std::max(half_.x(), half_.y());
    std::vector<Move> moves;
    for (const double step : {step_m, -step_m}) {
      const auto changed = [&](std::size_t k, double by) {
        Move m = at;
        m[k] += by;
        return m;
      };
      const Vec2 u = unitVector(prior_.heading + at[2]);
      const Vec2 v = perpendicular(u);
      for (const auto& [direction, k] :
           {std::pair{u, std::size_t{3}}, std::pair{v, std::size_t{4}}}) {
        Move shifted = at;
        shifted[0] += step * direction.x();
        shifted[1] += step * direction.y();
        moves.push_back(shifted);
        const double half = std::exp(at[k]) * (k == 3 ? half_.x() : half_.y());
        if (half + 0.5 * step < 0.5) continue;
        const double longer = std::log((half + 0.5 * step) / half);
        for (const double side : {0.5, -0.5}) {
          Move stretched = changed(k, longer);
          stretched[0] += side * step * direction.x();
          stretched[1] += side * step * direction.y();
          moves.push_back(stretched);
        }
        moves.push_back(changed(k, longer));
      }
      moves.push_back(changed(2, step / size));
      if (prior_.shear > 0.0) moves.push_back(changed(5, step / size));
    }
    return moves;
  }

 private:
  const OutlinePrior& prior_;
  Vec2 centre_;
  Vec2 half_;
  std::vector<Vec2> own_;  ///< corners along and across the axes
};

struct Candidate {
  Move move{};
  double total = -1e300;
};

void improve(Candidate& best, const Shape& shape, const OutlineScorer& scorer, double slack_m,
             double step_m, double least_step_m, std::size_t stride, const std::stop_token& stop) {
  const auto value = [&](const Move& m) {
    return scorer(shape(m), slack_m, stride) + shape.logPrior(m);
  };
  best.total = value(best.move);
  for (double step = step_m; step >= least_step_m; step *= 0.5) {
    constexpr int kMostRounds = 12;
    for (int round = 0; round < kMostRounds; ++round) {
      if (stop.stop_requested()) return;
      Candidate next = best;
      for (const Move& m : shape.moves(best.move, step)) {
        const double total = value(m);
        if (total > next.total) next = {m, total};
      }
      if (next.total <= best.total) break;
      best = next;
    }
  }
}

void keepBest(std::vector<Candidate>& candidates, std::size_t most) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.total > b.total; });
  candidates.resize(std::min(candidates.size(), most));
}

/// The outline with one wall moved along its normal; the walls beside it end where it is now.
Polygon withWallMoved(const Polygon& outline, std::size_t wall, double by) {
  const std::size_t n = outline.size();
  const std::size_t a = (wall + n - 1) % n;
  const Vec2 along = (outline[wall] - outline[a]).normalized();
  const Vec2 shift = -perpendicular(along) * by;
  Polygon moved = outline;
  const auto slide = [&](std::size_t corner, std::size_t beyond) {
    const Vec2 side = (outline[corner] - outline[beyond]).normalized();
    const double sine = cross(side, along);
    constexpr double kSteep = 0.5;
    moved[corner] += std::abs(sine) > kSteep ? Vec2(side * (cross(shift, along) / sine)) : shift;
  };
  slide(a, (a + n - 1) % n);
  slide(wall, (wall + 1) % n);
  return moved;
}

/// Wall by wall, each where the rays want it, as far as they outweigh that drawings are rather
/// right in their proportions.
void moveWalls(FittedOutline& fitted, const OutlinePrior& prior, const OutlineScorer& scorer,
               std::size_t stride, const std::stop_token& stop) {
  std::vector<double> moved(fitted.outline.size(), 0.0);
  const auto penalty = [&](double by) { return -0.5 * std::pow(by / prior.corner_m, 2); };
  for (double step = 0.8; step >= kLeastStep; step *= 0.5) {
    for (std::size_t wall = 0; wall < moved.size(); ++wall) {
      if (stop.stop_requested()) return;
      for (const double by : {step, -step}) {
        Polygon outline = withWallMoved(fitted.outline, wall, by);
        if (!isSimple(outline) || signedArea(outline) <= 0.0) continue;
        const double score = scorer(outline, kLastSlack, stride);
        const double changed = penalty(moved[wall] + by) - penalty(moved[wall]);
        if (score + changed <= fitted.score) continue;
        fitted.outline = std::move(outline);
        fitted.score = score;
        fitted.prior += changed;
        moved[wall] += by;
        break;
      }
    }
  }
}

}  // namespace

FittedOutline searchOutline(const OutlinePrior& prior, const OutlineScorer& scorer,
                            RandomStream random, const std::stop_token& stop) {
  const Shape shape(prior);
  const std::size_t coarse = 1 + scorer.size() / kAsked;
  const std::size_t fine = 1 + scorer.size() / kAskedLater;
  std::vector<Candidate> candidates(1);
  for (int i = 0; i < kSamples; ++i) candidates.push_back({shape.sample(random)});
  for (Candidate& candidate : candidates) {
    if (stop.stop_requested()) return {prior.start};
    candidate.total =
        scorer(shape(candidate.move), kSlackAtFirst, coarse) + shape.logPrior(candidate.move);
  }
  const Candidate start = candidates.front();
  for (const Stage& stage : kStages) {
    keepBest(candidates, stage.tries);
    for (Candidate& candidate : candidates) {
      if (stop.stop_requested()) return {prior.start};
      improve(candidate, shape, scorer, stage.slack_m, stage.step_m, 0.3 * stage.step_m, coarse,
              stop);
    }
  }
  // Narrow walls are found near where they are only: the start may be right as it is.
  keepBest(candidates, kFinalists);
  candidates.push_back(start);
  for (Candidate& candidate : candidates) {
    if (stop.stop_requested()) return {prior.start};
    improve(candidate, shape, scorer, kLastSlack, kLastStep, kLeastStep, fine, stop);
  }
  keepBest(candidates, 1);
  const Move& best = candidates.front().move;
  FittedOutline fitted{shape(best), 0.0, shape.logPrior(best)};
  fitted.score = scorer(fitted.outline, kLastSlack, fine);
  if (prior.corner_m > 0.0) moveWalls(fitted, prior, scorer, fine, stop);
  return fitted;
}

double spreadOfSide(const Polygon& outline, const Vec2& direction, double prior_sigma_m,
                    const OutlineScorer& scorer) {
  constexpr double kFirst = 0.05;  // metres
  constexpr double kDrop = 0.5;    // nats
  // What all rays share: poses, and walls that are not quite straight.
  constexpr double kSystematic_m = 0.2;
  const std::size_t stride = 1 + scorer.size() / kAskedLater;
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
    return scorer(moved, kLastSlack, stride) - 0.5 * std::pow(by / prior_sigma_m, 2);
  };
  const double best = value(0.0);
  double sigma = kFirst;
  while (sigma < prior_sigma_m && best - std::max(value(sigma), value(-sigma)) < kDrop) {
    sigma *= 1.5;
  }
  return std::min(std::hypot(sigma, kSystematic_m), std::max(prior_sigma_m, kSystematic_m));
}

}  // namespace handmap
