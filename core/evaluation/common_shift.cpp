#include "core/evaluation/common_shift.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

#include "core/base/gaussian.h"
#include "core/base/median.h"

namespace handmap {

namespace {

constexpr double kLeastSigma_m = 0.02;
constexpr double kMostOwn_m = 100.0;

/// Shift and turn of the drawing about the middle of its buildings, then of the way about its
/// start.
using State = Eigen::Matrix<double, 6, 1>;
using Information = Eigen::Matrix<double, 6, 6>;

/// One coordinate of the centroids of all buildings, along what varies apart from all else.
struct Residual {
  State slope;
  double moved = 0.0;
  double sigma = 0.0;
};

struct Fit {
  State mean = State::Zero();
  Information covariance = Information::Zero();
  double chi2 = 0.0;
};

/// What the drawing says: where the robot starts, and how it is turned.
Information statedBy(const Map& drawing) {
  static constexpr double kLeast = 1e-4;  // metres and radians
  const StartUncertainty start = drawing.start_uncertainty.value_or(StartUncertainty{});
  const auto of = [](double sigma) { return std::pow(std::max(sigma, kLeast), -2); };
  State information = State::Zero();
  if (drawing.whole.turn) information[2] = of(*drawing.whole.turn);
  information.tail<3>() << of(start.position), of(start.position), of(start.heading);
  return information.asDiagonal();
}

Fit fitted(const std::vector<Residual>& residuals, const Information& stated, double own) {
  Information normal = stated;
  State right = State::Zero();
  const auto weight = [own](const Residual& r) { return 1.0 / (r.sigma * r.sigma + own * own); };
  for (const Residual& r : residuals) {
    normal += weight(r) * r.slope * r.slope.transpose();
    right += weight(r) * r.slope * r.moved;
  }
  Fit fit;
  fit.covariance = normal.inverse();
  fit.mean = fit.covariance * right;
  for (const Residual& r : residuals) {
    const double left = r.moved - r.slope.dot(fit.mean);
    fit.chi2 += weight(r) * left * left;
  }
  return fit;
}

/// The centroid of a building as drawn, and how far off it was found.
struct Moved {
  Vec2 from;
  Vec2 moved;
  Vec2 sigma;
};

/// Without those that were taken for something else: they moved as no other did.
std::vector<Moved> withoutMistaken(std::vector<Moved> pairs) {
  constexpr double kMost = 4.0;  // σ of the spread
  for (const int axis : {0, 1}) {
    std::vector<double> moved;
    for (const Moved& pair : pairs) moved.push_back(pair.moved[axis]);
    const double middle = medianOf(moved);
    for (double& value : moved) value = std::abs(value - middle);
    const double spread = kMedianToSigma * medianOf(moved);
    std::erase_if(pairs, [&](const Moved& pair) {
      return std::abs(pair.moved[axis] - middle) > kMost * std::hypot(spread, pair.sigma[axis]);
    });
  }
  return pairs;
}

/// By what σ grows along the way, the way is off there, and with it all that is seen from there on:
/// two buildings share the smaller variance, less the least of all.
Eigen::MatrixXd covarianceOf(const Eigen::VectorXd& sigmas) {
  const Eigen::ArrayXd variances = sigmas.array().square();
  const Eigen::ArrayXd of_way = variances - variances.minCoeff();
  const Eigen::Index count = sigmas.size();
  const Eigen::MatrixXd rows = of_way.matrix().replicate(1, count);
  Eigen::MatrixXd covariance = rows.cwiseMin(rows.transpose());
  covariance.diagonal() = variances;
  return covariance;
}

void addResiduals(const std::vector<Moved>& pairs, int axis, const Vec2& middle, const Vec2& start,
                  std::vector<Residual>& residuals) {
  const auto count = static_cast<Eigen::Index>(pairs.size());
  Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(count, 6);
  Eigen::VectorXd moved(count);
  Eigen::VectorXd sigmas(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Moved& pair = pairs[static_cast<std::size_t>(i)];
    const Vec2 arm = pair.from - middle;
    const Vec2 far = pair.from - start;
    slopes(i, axis) = slopes(i, 3 + axis) = 1.0;
    slopes(i, 2) = axis == 0 ? -arm.y() : arm.x();
    slopes(i, 5) = axis == 0 ? -far.y() : far.x();
    moved[i] = pair.moved[axis];
    sigmas[i] = pair.sigma[axis];
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> apart(covarianceOf(sigmas));
  slopes = apart.eigenvectors().transpose() * slopes;
  moved = apart.eigenvectors().transpose() * moved;
  for (Eigen::Index i = 0; i < count; ++i) {
    residuals.push_back(
        {slopes.row(i), moved[i], std::sqrt(std::max(apart.eigenvalues()[i], 0.0))});
  }
}

}  // namespace

std::optional<CommonShift> commonShiftOf(const Map& drawing, const Map& refined) {
  std::vector<Moved> pairs;
  for (const Building& found : refined.buildings) {
    const Building* drawn = drawing.find(found.id);
    if (drawn == nullptr || !found.estimate || found.estimate->observations == 0) continue;
    const Vec2 from = centroid(drawn->footprint());
    const Vec2 sigma(std::max(found.estimate->sigma_x, kLeastSigma_m),
                     std::max(found.estimate->sigma_y, kLeastSigma_m));
    pairs.push_back({from, centroid(found.footprint()) - from, sigma});
  }
  if (pairs.size() >= 3) pairs = withoutMistaken(std::move(pairs));
  if (pairs.size() < 3) return std::nullopt;
  Vec2 middle = Vec2::Zero();
  for (const Moved& pair : pairs) middle += pair.from / static_cast<double>(pairs.size());
  const Vec2 start = drawing.start ? drawing.start->position() : middle;
  const Information stated = statedBy(drawing);
  std::vector<Residual> residuals;
  for (const int axis : {0, 1}) addResiduals(pairs, axis, middle, start, residuals);
  // As large that what is left is as large as it should be.
  const auto freedom = static_cast<double>(residuals.size() - 3);
  double low = 0.0;
  double high = kMostOwn_m;
  for (int i = 0; i < 60; ++i) {
    const double own = 0.5 * (low + high);
    (fitted(residuals, stated, own).chi2 > freedom ? low : high) = own;
  }
  const Fit fit = fitted(residuals, stated, low);
  CommonShift common;
  common.shift = fit.mean.head<2>();
  common.shift_sigma = fit.covariance.diagonal().head<2>().cwiseSqrt();
  common.turn = fit.mean[2];
  common.turn_sigma = std::sqrt(fit.covariance(2, 2));
  common.own = low;
  common.buildings = static_cast<int>(pairs.size());
  return common;
}

}  // namespace handmap
