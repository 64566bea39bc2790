#include "core/trajectory/factors.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace handmap {
namespace {

constexpr double kStep = 1e-6;

/// Slope of a function of a pose, by differences.
template <int Rows, typename Function>
Eigen::Matrix<double, Rows, 3> differences(const Function& residual, const Pose2& pose) {
  Eigen::Matrix<double, Rows, 3> slope;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
    slope.col(i) = (residual(stepped(pose, step)) - residual(stepped(pose, -step))) / (2 * kStep);
  }
  return slope;
}

const Pose2 kPose{3.0, -2.0, 2.6};

TEST(Factors, SlopeOfAPointOnALine) {
  const LineFactor factor{{4.0, 1.0}, {{-1.0, 0.5}, unitVector(0.7)}, 0.08};
  const auto residual = [&](const Pose2& pose) {
    return Eigen::Matrix<double, 1, 1>(factor.at(pose).residual);
  };
  EXPECT_TRUE(factor.at(kPose).slope.isApprox(differences<1>(residual, kPose), 1e-6));
}

TEST(Factors, SlopeOfAPointAtAPoint) {
  const PointFactor factor{{4.0, 1.0}, {-1.0, 0.5}, 0.3};
  const auto residual = [&](const Pose2& pose) { return factor.at(pose).residual; };
  EXPECT_TRUE(factor.at(kPose).slope.isApprox(differences<2>(residual, kPose), 1e-6));
}

TEST(Factors, AMotionIsLoosenedInOneDirection) {
  const MotionFactor factor{{1.5, 0.2, 0.4}, Eigen::Vector3d(10, 20, 200).asDiagonal()};
  Eigen::Matrix3d along = Eigen::Matrix3d::Zero();
  along(0, 0) = 4.0;
  const Eigen::Matrix3d root = loosened(factor, along).root_information;
  const Eigen::Vector3d sigma = (root.transpose() * root).inverse().diagonal().cwiseSqrt();
  EXPECT_NEAR(sigma.x(), std::hypot(0.1, 2.0), 1e-9);
  EXPECT_NEAR(sigma.y(), 0.05, 1e-9);
  EXPECT_NEAR(sigma.z(), 0.005, 1e-9);
}

TEST(Factors, SlopesOfAMotion) {
  MotionFactor factor{{1.5, 0.2, 0.4}, Eigen::Vector3d(10, 20, 200).asDiagonal()};
  factor.root_information(0, 2) = 30.0;
  const Pose2 next{2.0, -1.2, 3.1};
  const auto by_from = [&](const Pose2& pose) { return factor.at(pose, next).residual; };
  const auto by_to = [&](const Pose2& pose) { return factor.at(kPose, pose).residual; };
  const MotionFactor::Value value = factor.at(kPose, next);
  EXPECT_TRUE(value.from_slope.isApprox(differences<3>(by_from, kPose), 1e-6));
  EXPECT_TRUE(value.to_slope.isApprox(differences<3>(by_to, next), 1e-6));
}

TEST(Factors, VanishWhereAllIsAsMeasured) {
  const Pose2 motion{1.5, 0.2, 0.4};
  const MotionFactor factor{motion, Eigen::Matrix3d::Identity()};
  EXPECT_LT(factor.at(kPose, kPose * motion).residual.norm(), 1e-12);
  const Vec2 seen{4.0, 1.0};
  EXPECT_LT((PointFactor{seen, kPose.toOuter(seen), 0.3}.at(kPose).residual.norm()), 1e-12);
}

TEST(Factors, WeightIsTheSlopeOfTheCost) {
  for (const double square : {0.0, 3.0, 80.0}) {
    const double slope =
        (cauchyCost(square + kStep, 9.0) - cauchyCost(square - kStep, 9.0)) / (2 * kStep);
    EXPECT_NEAR(cauchyWeight(square, 9.0), slope, 1e-6);
  }
}

}  // namespace
}  // namespace handmap
