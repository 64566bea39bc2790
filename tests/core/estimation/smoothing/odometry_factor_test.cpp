#include "core/estimation/smoothing/odometry_factor.h"

#include "core/odometry/constants.h"
#include "tests/core/estimation/smoothing/numeric.h"

namespace handmap {
namespace {

class OdometryFactorTest : public testing::Test {
 protected:
  OdometryFactorTest() {
    from_.pose = {3.0, -2.0, 0.7};
    to_.pose = {5.1, -0.4, 1.1};
    from_.odometry = {10.0, 4.0, -0.3};
    to_.odometry = from_.odometry * Pose2{2.5, 0.2, 0.35};
  }
  Frame from_;
  Frame to_;
  OdometryNoise noise_ = kWheels;
};

TEST_F(OdometryFactorTest, SlopesAreThoseOfTheResidual) {
  noise_ = {0.0, 0.0, 0.05, 0.0, 0.0, 0.01};  // σ stays as it is
  double scale = 0.02;
  const auto factor = odometryFactor(from_, to_, scale, noise_);
  std::vector<Change> unknowns = unknownsOf(from_.pose);
  append(unknowns, unknownsOf(to_.pose));
  unknowns.push_back(unknown(scale));
  expectSlopes(factor.jacobian, unknowns, [&]() -> Eigen::VectorXd {
    return odometryFactor(from_, to_, scale, noise_).residual;
  });
}

TEST_F(OdometryFactorTest, NothingIsLeftWhereThePosesMovedAsCounted) {
  to_.pose = from_.pose * between(from_.odometry, to_.odometry);
  EXPECT_LT(odometryFactor(from_, to_, 0.0, noise_).residual.norm(), 1e-12);
  EXPECT_GT(odometryFactor(from_, to_, 0.1, noise_).residual.norm(), 0.2);
}

TEST_F(OdometryFactorTest, TurnsBeyondHalfATurnAreTheShortWay) {
  from_.pose.heading = kPi - 0.1;
  to_.pose.heading = -kPi + 0.25;
  EXPECT_NEAR(odometryFactor(from_, to_, 0.0, noise_).residual[2], 0.0, 1e-9);
}

TEST_F(OdometryFactorTest, MoreNoiseWeighsLess) {
  const auto usual = odometryFactor(from_, to_, 0.0, noise_);
  to_.odometry_noise = 3.0;
  const auto noisy = odometryFactor(from_, to_, 0.0, noise_);
  EXPECT_LT((3.0 * noisy.residual - usual.residual).norm(), 1e-9);
  EXPECT_LT((3.0 * noisy.jacobian - usual.jacobian).norm(), 1e-9);
  // 3 % and 1 cm of 2.51 m.
  EXPECT_NEAR(usual.jacobian.row(0).head<2>().norm(), 1.0 / (0.03 * std::hypot(2.5, 0.2) + 0.01),
              1e-6);
}

}  // namespace
}  // namespace handmap
