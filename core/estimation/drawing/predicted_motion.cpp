#include "core/estimation/drawing/predicted_motion.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/LU>

#include "core/estimation/drawing/constants.h"

namespace handmap {

using namespace drawing;

double predictiveShare(const DrawingMotion& expected, std::span<const Displaced> buildings) {
  std::vector<DrawingMotion::Slope> slopes;  // of the places, in σ
  std::vector<Vec2> differences;             // from what was expected, in σ
  Eigen::Matrix4d information =
      (expected.covariance + kLeastVariance * Eigen::Matrix4d::Identity()).inverse();
  Eigen::Vector4d pull = Eigen::Vector4d::Zero();
  for (const Displaced& building : buildings) {
    const DrawingMotion::Slope slope = expected.slopeAt(building.drawn) / building.sigma;
    const Vec2 difference = (building.found - expected(building.drawn)) / building.sigma;
    information += slope.transpose() * slope;
    pull += slope.transpose() * difference;
    slopes.push_back(slope);
    differences.push_back(difference);
  }
  // Least squares of the share, which is 0 ± 1 before.
  double agreed = 0.0;
  double squares = 1.0;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    const Eigen::Matrix4d of_others = information - slopes[i].transpose() * slopes[i];
    const Eigen::Vector4d by_others =
        of_others.inverse() * (pull - slopes[i].transpose() * differences[i]);
    const Vec2 predicted = slopes[i] * by_others;
    agreed += predicted.dot(differences[i]);
    squares += predicted.squaredNorm();
  }
  return std::clamp(agreed / squares, 0.0, 1.0);
}

double shareAt(double distance_m, double share) {
  return share * std::exp(-0.5 * std::pow(distance_m / kBlock_m, 2));
}

DrawingMotion predictedMotion(const DrawingMotion& expected, const DrawingMotion& found,
                              double share) {
  DrawingMotion motion = found;
  motion.mean = expected.mean + share * (found.mean - expected.mean);
  motion.covariance = expected.covariance + share * (found.covariance - expected.covariance);
  return motion;
}

}  // namespace handmap
