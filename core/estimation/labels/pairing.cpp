#include "core/estimation/labels/pairing.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <Eigen/Cholesky>

#include "core/estimation/buildings/constants.h"
#include "core/estimation/drawing/drawn_box.h"
#include "core/estimation/labels/constants.h"

namespace handmap {

using namespace labels;

namespace {

/// What a heading says of the drawing's turn: (a, b) lies along it. Returns its price; a building
/// that stands as it likes says nothing.
double compareHeading(double drawn, const FoundBox& found, double heading_sigma,
                      DrawingMotion& motion) {
  const Vec2 turn = unitVector(found.box.heading - drawn);
  const Eigen::RowVector4d slope(-turn.y(), turn.x(), 0.0, 0.0);
  const double sigma = motion.scale() * std::hypot(heading_sigma, found.heading_sigma);
  const double error = slope.dot(motion.mean);
  const double predicted = sigma * sigma + (slope * motion.covariance).dot(slope);
  const double price = 0.5 * error * error / predicted;
  if (price > kMostTurned) return kMostTurned;
  motion.correct(slope, 0.0, sigma * sigma);
  return price;
}

/// Walls that are beyond the gate already each for itself.
int farWalls(const DrawnBox& prior, const DrawingMotion& motion, const FoundBox& found,
             const SeenWalls& seen) {
  int far = 0;
  for (int i = 0; i < seen.count; ++i) {
    const int k = seen.index[static_cast<std::size_t>(i)];
    const auto wall = static_cast<std::size_t>(k);
    const double error = found.box.reach[wall] - prior.mean()[k];
    const auto slope = prior.slope().row(k);
    const double variance = prior.covariance()(k, k) + buildings::kFloor_m * buildings::kFloor_m +
                            found.covariance(k, k) + (slope * motion.covariance).dot(slope);
    far += static_cast<int>(error * error > kGate * variance);
  }
  return far;
}

/// Whether all of it was seen well and it is a thing of the size of a car, which no larger building
/// is, however wrong sizes may be drawn: where they are off by 3 m, a car is 2.3 σ from a house of
/// 9 m.
bool isCar(const Rectangle& drawn, const DrawingMotion& motion, const FoundBox& found) {
  const auto is_small = [](const Rectangle& box, double scale) {
    return scale * std::max(box.width, box.depth) < kCarLong_m &&
           scale * std::min(box.width, box.depth) < kCarWide_m;
  };
  for (std::size_t wall = 0; wall < 4; ++wall) {
    if (found.reachSigma(wall) > kCarWell_m) return false;
  }
  return is_small(found.box.rectangle(), 1.0) && !is_small(drawn, motion.scale());
}

/// How well some walls of a found box fit a drawn one, and what they say of the whole drawing.
struct Match {
  double distance;  ///< squared Mahalanobis
  double log_likelihood;
  Eigen::Vector4d mean_change;
  Eigen::Matrix4d covariance_change;
};

Match compareWalls(const DrawnBox& prior, const DrawingMotion& motion, const FoundBox& found,
                   std::span<const int> walls) {
  const auto count = static_cast<Eigen::Index>(walls.size());
  Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::DontAlign, 4, 4> slope(count, 4);
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1> error(count);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4> covariance(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const int k = walls[static_cast<std::size_t>(i)];
    slope.row(i) = prior.slope().row(k);
    error[i] = found.box.reach[static_cast<std::size_t>(k)] - prior.mean()[k];
    for (Eigen::Index j = 0; j < count; ++j) {
      const int other = walls[static_cast<std::size_t>(j)];
      covariance(i, j) = prior.covariance()(k, other) + found.covariance(k, other);
    }
    covariance(i, i) += buildings::kFloor_m * buildings::kFloor_m;
  }
  covariance += slope * motion.covariance * slope.transpose();
  const Eigen::LLT<decltype(covariance)> factor(covariance);
  const double distance = error.dot(factor.solve(error));
  const double log_determinant = 2.0 * factor.matrixLLT().diagonal().array().log().sum() +
                                 static_cast<double>(count) * std::log(2.0 * kPi);
  const auto seen_by_motion = (slope * motion.covariance).eval();
  const auto gain = factor.solve(seen_by_motion).transpose().eval();
  return {distance, -0.5 * (distance + log_determinant), gain * error, gain * seen_by_motion};
}

}  // namespace

std::optional<Pairing> pairing(const Rectangle& drawn, const Uncertainty& uncertainty,
                               const FoundBox& any, const DrawingMotion& before,
                               const PairingOptions& options) {
  const FoundBox found = any.nearestTo(drawn.heading + before.turn());
  const SeenWalls seen(found);
  if (seen.count == 0) return std::nullopt;
  Pairing result{0.0, seen.count, seen.widths, before};
  DrawingMotion& motion = result.motion;
  result.log_likelihood = -compareHeading(drawn.heading, found, options.heading_sigma, motion);
  if (isCar(drawn, motion, found)) return std::nullopt;
  const DrawnBox prior(drawn, uncertainty, motion, found.box);
  if (farWalls(prior, motion, found, seen) > 1) return std::nullopt;
  const auto count = static_cast<std::size_t>(seen.count);
  Match match = compareWalls(prior, motion, found, {seen.index.data(), count});
  // A wall may be of something built on to the building.
  const bool surprising = match.distance > kSurprising;
  for (std::size_t out = 0; surprising && count > 1 && out < count; ++out) {
    std::array<int, 4> others{};
    std::remove_copy(seen.index.begin(), seen.index.begin() + seen.count, others.begin(),
                     seen.index[out]);
    Match without = compareWalls(prior, motion, found, {others.data(), count - 1});
    without.log_likelihood += std::log(options.built_on / buildings::kChance_m);
    if (without.log_likelihood > match.log_likelihood) match = without;
  }
  if (!(match.distance <= kGate)) return std::nullopt;
  result.log_likelihood += match.log_likelihood;
  motion.mean += match.mean_change;
  motion.covariance -= match.covariance_change;
  return result;
}

}  // namespace handmap
