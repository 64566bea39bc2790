#include "core/sketch_study/pairwise.h"

#include <algorithm>
#include <cmath>

namespace handmap {

namespace {

struct DrawnPair {
  Vec2 truth;
  Vec2 drawn;
};

double angleOf(const Vec2& way) { return std::atan2(way.y(), way.x()); }

/// Relations of the truth, and those of them that the drawing has.
struct Relations {
  int all = 0;
  int right = 0;

  void add(const DrawnPair& pair) {
    for (const int axis : {0, 1}) {
      if (pair.truth[axis] == 0.0) continue;
      ++all;
      if (pair.truth[axis] * pair.drawn[axis] > 0.0) ++right;
    }
  }
};

void measureDistances(const std::vector<DrawnPair>& pairs, PairwiseMeasures& measures) {
  double true_most = 0.0;
  double drawn_most = 0.0;
  for (const DrawnPair& pair : pairs) {
    true_most = std::max(true_most, pair.truth.norm());
    drawn_most = std::max(drawn_most, pair.drawn.norm());
  }
  if (true_most <= 0.0 || drawn_most <= 0.0) return;
  double off = 0.0;
  for (const DrawnPair& pair : pairs) {
    const double error = pair.drawn.norm() / drawn_most - pair.truth.norm() / true_most;
    off += std::abs(error);
    measures.scaling_bias += error / static_cast<double>(pairs.size());
  }
  measures.distance_accuracy = 1.0 - off / static_cast<double>(pairs.size());
}

void measureAngles(const std::vector<DrawnPair>& pairs, PairwiseMeasures& measures) {
  double off = 0.0;
  Vec2 sum = Vec2::Zero();
  for (const DrawnPair& pair : pairs) {
    const double error = normalizedAngle(angleOf(pair.drawn) - angleOf(pair.truth));
    off += std::abs(error) / kPi;
    sum += unitVector(error);
  }
  measures.angle_accuracy = 1.0 - off / static_cast<double>(pairs.size());
  measures.rotational_bias_rad = angleOf(sum);
}

}  // namespace

double PairwiseMeasures::organisationRoot() const { return std::sqrt(canonical_organisation); }
double PairwiseMeasures::accuracyRoot() const { return std::sqrt(canonical_accuracy); }

PairwiseMeasures pairwiseMeasures(const std::vector<Vec2>& truth,
                                  const std::vector<std::optional<Vec2>>& drawn) {
  PairwiseMeasures measures;
  measures.landmarks = static_cast<int>(truth.size());
  measures.missing = static_cast<int>(
      std::ranges::count_if(drawn, [](const auto& place) { return !place.has_value(); }));
  std::vector<DrawnPair> pairs;
  Relations of_drawn;
  int all = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vec2 way = truth[i] - truth[j];
      all += (way.x() != 0.0) + (way.y() != 0.0);
      if (!drawn[i] || !drawn[j]) continue;
      pairs.push_back({way, *drawn[i] - *drawn[j]});
      of_drawn.add(pairs.back());
    }
  }
  if (all > 0) measures.canonical_organisation = static_cast<double>(of_drawn.right) / all;
  if (of_drawn.all == 0) return measures;
  measures.canonical_accuracy = static_cast<double>(of_drawn.right) / of_drawn.all;
  measureDistances(pairs, measures);
  measureAngles(pairs, measures);
  return measures;
}

}  // namespace handmap
