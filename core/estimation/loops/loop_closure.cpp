#include "core/estimation/loops/loop_closure.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "core/estimation/buildings/constants.h"
#include "core/estimation/loops/constants.h"

namespace handmap {

using namespace loops;

namespace {

/// A way to close the loop that grows pair by pair: what the drift is if it is right.
struct Trial {
  std::vector<SameBuilding> pairs;
  Eigen::Vector3d drift = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance;
  double evidence = 0.0;

  bool has(const SameBuilding& pair) const {
    return std::any_of(pairs.begin(), pairs.end(),
                       [&](const SameBuilding& other) { return other.old == pair.old; });
  }
};

class LoopCloser {
 public:
  LoopCloser(std::span<const FoundBox> boxes, std::span<const SameBuilding> candidates,
             const DriftPrior& prior)
      : candidates_(candidates), here_(prior.here) {
    root_.covariance = Eigen::Vector3d(prior.shift_m, prior.shift_m, prior.turn)
                           .cwiseAbs2()
                           .asDiagonal()
                           .toDenseMatrix();
    for (const SameBuilding& pair : candidates) {
      shared_.push_back(compare(*findBox(boxes, pair.old), *findBox(boxes, pair.again)));
    }
  }

  /// Begun with each pair, the best.
  std::optional<Trial> best() const {
    std::optional<Trial> best;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      std::optional<Trial> trial = extended(root_, i);
      if (!trial) continue;
      grow(*trial);
      if (!best || trial->evidence > best->evidence) best = std::move(trial);
    }
    return best;
  }

 private:
  /// Adds the pair that brings most until none brings anything.
  void grow(Trial& trial) const {
    while (true) {
      std::optional<Trial> best;
      for (std::size_t i = 0; i < candidates_.size(); ++i) {
        if (trial.has(candidates_[i])) continue;
        std::optional<Trial> next = extended(trial, i);
        if (next && next->evidence > (best ? best->evidence : trial.evidence)) best = next;
      }
      if (!best) return;
      trial = std::move(*best);
    }
  }

  std::optional<Trial> extended(const Trial& trial, std::size_t candidate) const {
    const std::vector<SharedParameter>& shared = shared_[candidate];
    if (shared.empty()) return std::nullopt;
    Trial next = trial;
    next.pairs.push_back(candidates_[candidate]);
    for (const SharedParameter& parameter : shared) {
      Eigen::RowVector3d slope(0.0, 0.0, 1.0);
      if (parameter.old_parameter != buildings::kHeading) {
        slope << parameter.normal.x(), parameter.normal.y(),
            parameter.normal.dot(perpendicular(parameter.point - here_));
      }
      const Eigen::Vector3d seen = next.covariance * slope.transpose();
      const double variance = slope.dot(seen) + parameter.variance;
      const double error = parameter.error - slope.dot(next.drift);
      const double distance = error * error / variance;
      if (distance > kGate) return std::nullopt;
      const double spread =
          parameter.old_parameter == buildings::kHeading ? kPi / 2.0 : buildings::kChance_m;
      next.evidence += std::log(spread / std::sqrt(2.0 * kPi * variance)) - 0.5 * distance;
      next.drift += seen * (error / variance);
      next.covariance -= seen * seen.transpose() / variance;
    }
    return next;
  }

  std::span<const SameBuilding> candidates_;
  Vec2 here_;
  Trial root_;
  std::vector<std::vector<SharedParameter>> shared_;  ///< by candidate
};

}  // namespace

std::optional<std::vector<SameBuilding>> closeLoop(std::span<const FoundBox> boxes,
                                                   std::span<const SameBuilding> candidates,
                                                   const DriftPrior& prior) {
  std::optional<Trial> best = LoopCloser(boxes, candidates, prior).best();
  if (!best || best->pairs.size() < 2 || best->evidence < kSure) return std::nullopt;
  return std::move(best->pairs);
}

}  // namespace handmap
