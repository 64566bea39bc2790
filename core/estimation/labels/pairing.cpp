#include "core/estimation/labels/pairing.h"

#include <algorithm>
#include <cmath>

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

/// How well walls of a found box fit a drawn one. What was not seen is a row that says nothing.
struct Match {
  Eigen::Matrix4d slope = Eigen::Matrix4d::Zero();  ///< of the errors, by the motion
  Eigen::Vector4d error = Eigen::Vector4d::Zero();
  Eigen::Vector4d variance;  ///< of each wall for itself
  Eigen::Matrix4d weight;    ///< of the errors together: their covariance inverted
  double distance = 0.0;     ///< squared Mahalanobis
  double log_likelihood = 0.0;

  /// The same with one wall less: what it is off where the others are known says what it added.
  Match without(int wall) const {
    Match rest = *this;
    const Eigen::Vector4d column = weight.col(wall);
    const double added = column.dot(error) * column.dot(error) / column[wall];
    rest.weight -= column * column.transpose() / column[wall];
    rest.distance -= added;
    rest.log_likelihood += 0.5 * (added + std::log(2.0 * kPi / column[wall]));
    return rest;
  }
};

Match compareWalls(const DrawnBox& prior, const DrawingMotion& motion, const FoundBox& found,
                   const SeenWalls& seen) {
  Match match;
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Identity();
  for (int i = 0; i < seen.count; ++i) {
    const int k = seen.index[static_cast<std::size_t>(i)];
    match.slope.row(k) = prior.slope().row(k);
    match.error[k] = found.box.reach[static_cast<std::size_t>(k)] - prior.mean()[k];
    for (int j = 0; j < seen.count; ++j) {
      const int other = seen.index[static_cast<std::size_t>(j)];
      covariance(k, other) = prior.covariance()(k, other) + found.covariance(k, other);
    }
    covariance(k, k) += buildings::kFloor_m * buildings::kFloor_m;
  }
  covariance += match.slope * motion.covariance * match.slope.transpose();
  const Eigen::LLT<Eigen::Matrix4d> factor(covariance);
  Eigen::Matrix4d whitened;  // column by column: so Eigen does it without loops
  for (int k = 0; k < 4; ++k) {
    whitened.col(k) = factor.matrixL().solve(Eigen::Vector4d::Unit(k));
  }
  match.variance = covariance.diagonal();
  match.weight = whitened.transpose() * whitened;
  match.distance = (whitened * match.error).squaredNorm();
  match.log_likelihood = std::log(whitened.diagonal().prod()) - 0.5 * match.distance -
                         0.5 * static_cast<double>(seen.count) * std::log(2.0 * kPi);
  return match;
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
  Match match = compareWalls(prior, motion, found, seen);
  // Two walls are beyond the gate already each for itself.
  if ((match.error.array().square() > kGate * match.variance.array()).count() > 1) {
    return std::nullopt;
  }
  // A wall may be of something built on to the building.
  if (seen.count > 1) {
    const Match all = match;
    for (int i = 0; i < seen.count; ++i) {
      Match rest = all.without(seen.index[static_cast<std::size_t>(i)]);
      rest.log_likelihood += std::log(options.built_on / buildings::kChance_m);
      if (rest.log_likelihood > match.log_likelihood) match = rest;
    }
  }
  if (!(match.distance <= kGate)) return std::nullopt;
  result.log_likelihood += match.log_likelihood;
  const Eigen::Matrix4d seen_by_motion = match.slope * motion.covariance;
  const Eigen::Matrix4d gain = seen_by_motion.transpose() * match.weight;
  motion.mean += gain * match.error;
  motion.covariance -= gain * seen_by_motion;
  return result;
}

}  // namespace handmap
