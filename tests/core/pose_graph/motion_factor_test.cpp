#include "core/pose_graph/motion_factor.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "tests/core/pose_graph/differences.h"

namespace handmap {
namespace {

using test::differences;

const Pose2 kPose{3.0, -2.0, 2.6};

TEST(MotionFactor, IsLoosenedInOneDirection) {
  const MotionFactor factor{{1.5, 0.2, 0.4}, Eigen::Vector3d(10, 20, 200).asDiagonal()};
  Eigen::Matrix3d along = Eigen::Matrix3d::Zero();
  along(0, 0) = 4.0;
  const Eigen::Matrix3d root = loosened(factor, along).root_information;
  const Eigen::Vector3d sigma = (root.transpose() * root).inverse().diagonal().cwiseSqrt();
  EXPECT_NEAR(sigma.x(), std::hypot(0.1, 2.0), 1e-9);
  EXPECT_NEAR(sigma.y(), 0.05, 1e-9);
  EXPECT_NEAR(sigma.z(), 0.005, 1e-9);
}

TEST(MotionFactor, HasSlopes) {
  MotionFactor factor{{1.5, 0.2, 0.4}, Eigen::Vector3d(10, 20, 200).asDiagonal()};
  factor.root_information(0, 2) = 30.0;
  const Pose2 next{2.0, -1.2, 3.1};
  const auto by_from = [&](const Pose2& pose) { return factor.at(pose, next).residual; };
  const auto by_to = [&](const Pose2& pose) { return factor.at(kPose, pose).residual; };
  const auto jacobian = factor.at(kPose, next).jacobian;
  EXPECT_TRUE(jacobian.leftCols<3>().isApprox(differences<3>(by_from, kPose), 1e-6));
  EXPECT_TRUE(jacobian.rightCols<3>().isApprox(differences<3>(by_to, next), 1e-6));
}

TEST(MotionFactor, VanishesWhereThePosesMovedAsMeasured) {
  const Pose2 motion{1.5, 0.2, 0.4};
  const MotionFactor factor{motion, Eigen::Matrix3d::Identity()};
  EXPECT_LT(factor.at(kPose, kPose * motion).residual.norm(), 1e-12);
}

TEST(CauchysKernel, WeightIsTheSlopeOfTheCost) {
  for (const double square : {0.0, 3.0, 80.0}) {
    const double slope =
        (cauchyCost(square + test::kStep, 9.0) - cauchyCost(square - test::kStep, 9.0)) /
        (2 * test::kStep);
    EXPECT_NEAR(cauchyWeight(square, 9.0), slope, 1e-6);
  }
}

}  // namespace
}  // namespace handmap
