#include "core/trajectory/factors.h"

#include <gtest/gtest.h>

#include "tests/core/pose_graph/differences.h"

namespace handmap {
namespace {

using test::differences;

const Pose2 kPose{3.0, -2.0, 2.6};

TEST(Factors, SlopeOfAPointOnALine) {
  const LineFactor factor{{4.0, 1.0}, {{-1.0, 0.5}, unitVector(0.7)}, 0.08};
  const auto residual = [&](const Pose2& pose) {
    return Eigen::Matrix<double, 1, 1>(factor.at(ToOuter(pose)).residual);
  };
  EXPECT_TRUE(factor.at(ToOuter(kPose)).slope.isApprox(differences<1>(residual, kPose), 1e-6));
}

TEST(Factors, SlopeOfAPointAtAPoint) {
  const PointFactor factor{{4.0, 1.0}, {-1.0, 0.5}, 0.3};
  const auto residual = [&](const Pose2& pose) { return factor.at(ToOuter(pose)).residual; };
  EXPECT_TRUE(factor.at(ToOuter(kPose)).slope.isApprox(differences<2>(residual, kPose), 1e-6));
}

TEST(Factors, VanishWhereAReturnIsAsMapped) {
  const Vec2 seen{4.0, 1.0};
  EXPECT_LT((PointFactor{seen, kPose.toOuter(seen), 0.3}.at(ToOuter(kPose)).residual.norm()),
            1e-12);
}

}  // namespace
}  // namespace handmap
