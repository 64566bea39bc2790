#include "core/method/pose_trust.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

#include "core/base/gaussian.h"
#include "core/map/certainty.h"
#include "core/method/constants.h"
#include "core/method/recognition.h"
#include "core/odometry/constants.h"

namespace handmap {

using namespace method;

namespace {

double cumulative(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

}  // namespace

double probabilityWithin(const Eigen::Matrix2d& covariance, double distance_m) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(covariance);
  const auto sigma = [&](Eigen::Index i) {
    return std::sqrt(std::max(axes.eigenvalues()[i], kLeast_m * kLeast_m));
  };
  const double narrow = sigma(0);
  const double wide = sigma(1);
  // Along the wide axis by the midpoint rule, across it exactly.
  const double end = std::min(distance_m, kMostSigmas * wide);
  double sum = 0.0;
  for (int i = 0; i < kIntegralSteps; ++i) {
    const double at = end * (i + 0.5) / kIntegralSteps;
    const double across = std::sqrt(std::max(0.0, distance_m * distance_m - at * at));
    const double z = at / wide;
    sum += std::exp(-0.5 * z * z) * (2.0 * cumulative(across / narrow) - 1.0);
  }
  return std::min(1.0, 2.0 * sum * end / kIntegralSteps / (wide * std::sqrt(2.0 * kPi)));
}

double radiusHolding(const Eigen::Matrix2d& covariance, double probability) {
  double low = 0.0;
  double high = kLeast_m;
  while (high < kFarthest_m && probabilityWithin(covariance, high) < probability) high *= 2.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (probabilityWithin(covariance, middle) < probability ? low : high) = middle;
  }
  return high;
}

Eigen::Matrix2d positionCovariance(const FrameReport& report) {
  const auto& [x, y, heading] = report.pose_sigma;
  Eigen::Matrix2d covariance;
  covariance << x * x, report.pose_xy, report.pose_xy, y * y;
  return covariance;
}

Eigen::Matrix3d poseCovariance(const FrameReport& report) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  covariance.topLeftCorner<2, 2>() = positionCovariance(report);
  covariance(2, 2) = report.pose_sigma[2] * report.pose_sigma[2];
  return covariance;
}

void stateBlind(double blind_s, FrameReport& report) {
  if (blind_s <= 0.0) return;
  const Eigen::Array3d off =
      blind_s *
      Eigen::Array3d(odometry::kUnheard_m_s, odometry::kUnheard_m_s, odometry::kUnheard_rad_s);
  Eigen::Matrix3d covariance = poseCovariance(report);
  covariance.diagonal().array() += off.square();
  stateTrust(covariance, report);
}

double certainWithin(const FrameReport& report) {
  return radiusHolding(positionCovariance(report), kHowOften);
}

void stateTrust(const Eigen::Matrix3d& covariance, FrameReport& report) {
  const Eigen::Array3d sigma = covariance.diagonal().array().max(0.0).sqrt();
  report.pose_sigma = {sigma[0], sigma[1], sigma[2]};
  report.pose_xy = covariance(0, 1);
  for (std::size_t i = 0; i < kWithin_m.size(); ++i) {
    report.within[i] = probabilityWithin(covariance.topLeftCorner<2, 2>(), kWithin_m[i]);
  }
}

PoseCertainty certaintyOf(const FrameReport& report) {
  PoseCertainty certainty{Certainty::Lost, certainWithin(report),
                          kHeadingSigmas * report.pose_sigma[2]};
  if (certainty.heading_rad > kPi / 2.0) return certainty;
  if (certainty.within_m <= kRoughWithin_m) certainty.kind = Certainty::Rough;
  if (certainty.within_m <= kSureWithin_m && certainty.heading_rad <= kSureHeading &&
      report.unrecognised_m < kUnrecognised_m) {
    certainty.kind = Certainty::Sure;
  }
  return certainty;
}

std::vector<BuildingTrust> trustOf(const Map& refined) {
  std::vector<BuildingTrust> trusts;
  for (std::size_t b = 0; b < refined.buildings.size(); ++b) {
    const Building& building = refined.buildings[b];
    if (!isRecognised(building)) continue;
    BuildingTrust trust{b, {}, kWithinSigma * (1.0 - doubtOf(building))};
    const Sides sides = sidesOf(building);
    for (std::size_t k = 0; k < sides.size(); ++k) trust.sigma_m[k] = sides[k].sigma;
    trusts.push_back(trust);
  }
  return trusts;
}

}  // namespace handmap
