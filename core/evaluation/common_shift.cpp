#include "core/evaluation/common_shift.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

namespace handmap {

namespace {

constexpr double kLeastSigma_m = 0.02;
constexpr double kMostOwn_m = 100.0;

/// One coordinate of the centre of one building.
struct Residual {
  Eigen::RowVector3d slope;  ///< by shift x, shift y and turn
  double moved = 0.0;
  double sigma = 0.0;
};

struct Fit {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double chi2 = 0.0;
};

Fit fitted(const std::vector<Residual>& residuals, double own) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const auto weight = [own](const Residual& r) { return 1.0 / (r.sigma * r.sigma + own * own); };
  for (const Residual& r : residuals) {
    normal += weight(r) * r.slope.transpose() * r.slope;
    right += weight(r) * r.slope.transpose() * r.moved;
  }
  Fit fit;
  fit.covariance = normal.inverse();
  fit.mean = fit.covariance * right;
  for (const Residual& r : residuals) {
    const double left = r.moved - r.slope * fit.mean;
    fit.chi2 += weight(r) * left * left;
  }
  return fit;
}

/// The centre of a building as drawn, and how far off it was found.
struct Moved {
  Vec2 from;
  Vec2 moved;
  Vec2 sigma;
};

double middleOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Without those that were taken for something else: they moved as no other did.
std::vector<Moved> withoutMistaken(std::vector<Moved> pairs) {
  constexpr double kMost = 4.0;              // σ of the spread
  constexpr double kSigmaOfMedian = 1.4826;  // of a normal error
  for (const int axis : {0, 1}) {
    std::vector<double> moved;
    for (const Moved& pair : pairs) moved.push_back(pair.moved[axis]);
    const double middle = middleOf(moved);
    for (double& value : moved) value = std::abs(value - middle);
    const double spread = kSigmaOfMedian * middleOf(moved);
    std::erase_if(pairs, [&](const Moved& pair) {
      return std::abs(pair.moved[axis] - middle) > kMost * std::hypot(spread, pair.sigma[axis]);
    });
  }
  return pairs;
}

}  // namespace

std::optional<CommonShift> commonShiftOf(const Map& drawing, const Map& refined) {
  std::vector<Moved> pairs;
  for (const Building& found : refined.buildings) {
    const Building* drawn = drawing.find(found.id);
    if (drawn == nullptr || !found.estimate || found.estimate->observations == 0) continue;
    const Vec2 from = drawn->box().centre;
    const Vec2 sigma(std::max(found.estimate->sigma_x, kLeastSigma_m),
                     std::max(found.estimate->sigma_y, kLeastSigma_m));
    pairs.push_back({from, found.box().centre - from, sigma});
  }
  if (pairs.size() >= 3) pairs = withoutMistaken(std::move(pairs));
  if (pairs.size() < 3) return std::nullopt;
  Vec2 middle = Vec2::Zero();
  for (const Moved& pair : pairs) middle += pair.from / static_cast<double>(pairs.size());
  std::vector<Residual> residuals;
  for (const Moved& pair : pairs) {
    const Vec2 arm = pair.from - middle;
    residuals.push_back({{1.0, 0.0, -arm.y()}, pair.moved.x(), pair.sigma.x()});
    residuals.push_back({{0.0, 1.0, arm.x()}, pair.moved.y(), pair.sigma.y()});
  }
  // As large that what is left is as large as it should be.
  const auto freedom = static_cast<double>(residuals.size() - 3);
  double low = 0.0;
  double high = kMostOwn_m;
  for (int i = 0; i < 60; ++i) {
    const double own = 0.5 * (low + high);
    (fitted(residuals, own).chi2 > freedom ? low : high) = own;
  }
  const Fit fit = fitted(residuals, low);
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
