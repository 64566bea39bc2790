#include "core/estimation/loop_closure.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

namespace handmap {

namespace {

constexpr std::size_t kHeading = 4;
constexpr double kSeen = 1.0;       // metres, one σ, of a wall that is compared
constexpr double kWallFloor = 0.2;  // metres, one σ, of what two boxes of a wall may differ
constexpr double kHeadingFloor = 0.02;
constexpr double kGate = 12.0;    // squared Mahalanobis distance of one parameter
constexpr double kChance = 60.0;  // metres over which walls of other buildings are spread
constexpr double kSure = 10.0;    // nats

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
      agreements_.push_back(compare(boxes[pair.old], boxes[pair.again]));
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
    const std::vector<Agreement>& agreements = agreements_[candidate];
    if (agreements.empty()) return std::nullopt;
    Trial next = trial;
    next.pairs.push_back(candidates_[candidate]);
    for (const Agreement& agreement : agreements) {
      Eigen::RowVector3d slope(0.0, 0.0, 1.0);
      if (agreement.old_parameter != kHeading) {
        slope << agreement.normal.x(), agreement.normal.y(),
            agreement.normal.dot(perpendicular(agreement.point - here_));
      }
      const Eigen::Vector3d seen = next.covariance * slope.transpose();
      const double variance = slope.dot(seen) + agreement.variance;
      const double error = agreement.error - slope.dot(next.drift);
      const double distance = error * error / variance;
      if (distance > kGate) return std::nullopt;
      const double spread = agreement.old_parameter == kHeading ? kPi / 2.0 : kChance;
      next.evidence += std::log(spread / std::sqrt(2.0 * kPi * variance)) - 0.5 * distance;
      next.drift += seen * (error / variance);
      next.covariance -= seen * seen.transpose() / variance;
    }
    return next;
  }

  std::span<const SameBuilding> candidates_;
  Vec2 here_;
  Trial root_;
  std::vector<std::vector<Agreement>> agreements_;  ///< by candidate
};

}  // namespace

std::vector<Agreement> compare(const FoundBox& old, const FoundBox& again) {
  const Box& a = old.box;
  const Box& b = again.box;
  const std::size_t quarters = b.quartersTo(a.heading);
  std::vector<Agreement> agreements;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t j = (k + quarters) % 4;
    if (old.reachSigma(k) > kSeen || again.reachSigma(j) > kSeen) continue;
    Agreement wall;
    wall.old_parameter = k;
    wall.again_parameter = j;
    wall.normal = a.sideNormal(k);
    wall.point = (b.boxCorner(j) + b.boxCorner((j + 3) % 4)) / 2.0;
    wall.error = a.reach[k] - wall.normal.dot(wall.point - a.pivot);
    wall.old_slope.setZero();
    wall.again_slope.setZero();
    wall.old_slope[static_cast<Eigen::Index>(k)] = 1.0;
    wall.old_slope[kHeading] = -perpendicular(wall.normal).dot(wall.point - a.pivot);
    wall.again_slope[static_cast<Eigen::Index>(j)] = -wall.normal.dot(b.sideNormal(j));
    wall.again_slope[kHeading] = -wall.normal.dot(perpendicular(wall.point - b.pivot));
    wall.variance = old.reachSigma(k) * old.reachSigma(k) +
                    again.reachSigma(j) * again.reachSigma(j) + kWallFloor * kWallFloor;
    agreements.push_back(wall);
  }
  if (agreements.empty()) return agreements;
  Agreement heading{kHeading,
                    kHeading,
                    std::remainder(a.heading - b.heading, kPi / 2.0),
                    {},
                    {},
                    Vec2::Zero(),
                    Vec2::Zero(),
                    old.heading_sigma * old.heading_sigma +
                        again.heading_sigma * again.heading_sigma + kHeadingFloor * kHeadingFloor};
  heading.old_slope = Eigen::Matrix<double, 5, 1>::Unit(kHeading);
  heading.again_slope = -heading.old_slope;
  agreements.push_back(heading);
  return agreements;
}

FoundBox merged(const FoundBox& old, const FoundBox& again) {
  FoundBox result = old;
  const FoundBox turned = again.nearestTo(old.box.heading);
  for (std::size_t k = 0; k < 4; ++k) {
    if (turned.reachSigma(k) >= old.reachSigma(k)) continue;
    const Vec2 wall = turned.box.pivot + turned.box.reach[k] * turned.box.sideNormal(k);
    result.box.reach[k] = old.box.sideNormal(k).dot(wall - old.box.pivot);
    result.setReachSigma(k, turned.reachSigma(k));
  }
  result.score = again.score;
  result.in_sight = again.in_sight;
  result.last_frame = again.last_frame;
  result.asleep = false;
  return result;
}

std::vector<FoundBox> merged(std::span<const FoundBox> boxes, std::span<const SameBuilding> pairs) {
  std::vector<FoundBox> kept;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto pair = std::find_if(pairs.begin(), pairs.end(), [&](const SameBuilding& p) {
      return p.old == i || p.again == i;
    });
    if (pair == pairs.end()) {
      kept.push_back(boxes[i]);
    } else if (pair->old == i) {
      kept.push_back(merged(boxes[i], boxes[pair->again]));
    }
  }
  return kept;
}

std::optional<std::vector<SameBuilding>> closeLoop(std::span<const FoundBox> boxes,
                                                   std::span<const SameBuilding> candidates,
                                                   const DriftPrior& prior) {
  std::optional<Trial> best = LoopCloser(boxes, candidates, prior).best();
  if (!best || best->pairs.size() < 2 || best->evidence < kSure) return std::nullopt;
  return std::move(best->pairs);
}

}  // namespace handmap
