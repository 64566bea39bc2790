#include "core/geometry/pose_covariance.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

TEST(PoseCovariance, ATurnedFrameHasItsLongAxisElsewhere) {
  const Eigen::Matrix3d along = Eigen::Vector3d(4.0, 1.0, 0.01).asDiagonal();
  const Eigen::Matrix3d up = turnedBy(kPi / 2.0, along);
  EXPECT_TRUE(up.isApprox(Eigen::Matrix3d(Eigen::Vector3d(1.0, 4.0, 0.01).asDiagonal()), 1e-12));
}

TEST(PoseCovariance, AHeadingSwingsTheEndOfALever) {
  const Eigen::Matrix3d heading = Eigen::Vector3d(0.0, 0.0, 0.02 * 0.02).asDiagonal();
  const Eigen::Matrix3d end = swungBy({10.0, 0.0}, heading);
  EXPECT_NEAR(std::sqrt(end(1, 1)), 0.2, 1e-12);
  EXPECT_NEAR(end(0, 0), 0.0, 1e-12);
  EXPECT_NEAR(end(1, 2), 0.2 * 0.02, 1e-12);
  EXPECT_NEAR(end(2, 2), heading(2, 2), 1e-15);
}

}  // namespace
}  // namespace handmap
