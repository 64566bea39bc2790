#include "core/sketch_study/bidimensional.h"

#include <cmath>

#include <Eigen/Dense>

namespace handmap {

namespace {

constexpr double kLeastSpread = 1e-9;  // of places, against their distance from the origin

Vec2 middleOf(const std::vector<Vec2>& points) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

/// Those of the model beyond the two of the shift.
int modelFreedom(Transformation transformation) {
  return transformation == Transformation::Euclidean ? 2 : 4;
}

int residualFreedom(Transformation transformation, int points) {
  return 2 * points - 2 - modelFreedom(transformation);
}

/// Upper tail of the F distribution, exact for 2 or 4 degrees of freedom above: the incomplete beta
/// function is a polynomial there.
double upperTail(double left_share, int model_df, int residual_df) {
  const double half = residual_df / 2.0;
  const double power = std::pow(left_share, half);
  return model_df == 2 ? power : power * (1.0 + half * (1.0 - left_share));
}

FitTest testOf(double left_share, int model_df, int residual_df, int points) {
  FitTest test;
  test.model_df = model_df;
  test.residual_df = residual_df;
  test.f = (1.0 - left_share) / model_df / (left_share / residual_df);
  test.p = upperTail(left_share, model_df, residual_df);
  test.aic = 2.0 * points * std::log(left_share) + 2.0 * model_df;
  return test;
}

}  // namespace

double BidimensionalFit::r() const { return std::sqrt(std::max(0.0, r_squared)); }
double BidimensionalFit::distortionIndex() const { return distortion / max_distortion; }
double BidimensionalFit::theta() const { return std::atan2(linear(1, 0), linear(0, 0)); }
double BidimensionalFit::scaleX() const { return linear.col(0).norm(); }
double BidimensionalFit::scaleY() const { return linear.determinant() / scaleX(); }
double BidimensionalFit::shear() const {
  return linear.col(0).dot(linear.col(1)) / linear.determinant();
}
FitTest BidimensionalFit::test() const { return testOf(transformation, r_squared, points); }

FitTest testOf(Transformation transformation, double r_squared, int points) {
  return testOf(1.0 - r_squared, modelFreedom(transformation),
                residualFreedom(transformation, points), points);
}

FitTest testAgainst(const BidimensionalFit& euclidean, const BidimensionalFit& affine) {
  return testOf((1.0 - affine.r_squared) / (1.0 - euclidean.r_squared),
                modelFreedom(Transformation::Affine) - modelFreedom(Transformation::Euclidean),
                residualFreedom(Transformation::Affine, affine.points), affine.points);
}

std::optional<BidimensionalFit> bidimensionalRegression(const std::vector<Vec2>& independent,
                                                        const std::vector<Vec2>& dependent,
                                                        Transformation transformation) {
  const int points = static_cast<int>(independent.size());
  if (independent.size() != dependent.size() || residualFreedom(transformation, points) < 1) {
    return std::nullopt;
  }
  const Vec2 from = middleOf(independent);
  const Vec2 to = middleOf(dependent);
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();  // of the independent places
  Eigen::Matrix2d joint = Eigen::Matrix2d::Zero();
  BidimensionalFit fit;
  for (std::size_t i = 0; i < independent.size(); ++i) {
    const Vec2 x = independent[i] - from;
    const Vec2 y = dependent[i] - to;
    spread += x * x.transpose();
    joint += y * x.transpose();
    fit.max_distortion += y.squaredNorm();
  }
  const double least = kLeastSpread * kLeastSpread * (1.0 + from.squaredNorm());
  const bool affine = transformation == Transformation::Affine;
  const double smallest = affine ? spread.determinant() / spread.trace() : spread.trace();
  if (!(smallest > least) || fit.max_distortion <= 0.0) return std::nullopt;
  if (affine) {
    fit.linear = joint * spread.inverse();
  } else {
    const double along = joint.trace() / spread.trace();
    const double across = (joint(1, 0) - joint(0, 1)) / spread.trace();
    fit.linear << along, -across, across, along;
  }
  fit.transformation = transformation;
  fit.points = points;
  fit.shift = to - fit.linear * from;
  for (std::size_t i = 0; i < independent.size(); ++i) {
    fit.distortion += (dependent[i] - fit.apply(independent[i])).squaredNorm();
  }
  fit.r_squared = 1.0 - fit.distortion / fit.max_distortion;
  fit.distortion = std::sqrt(fit.distortion);
  fit.max_distortion = std::sqrt(fit.max_distortion);
  return fit;
}

}  // namespace handmap
