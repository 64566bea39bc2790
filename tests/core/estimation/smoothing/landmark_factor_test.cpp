#include "core/estimation/smoothing/landmark_factor.h"

#include "tests/core/estimation/smoothing/numeric.h"

namespace handmap {
namespace {

class LandmarkFactorTest : public testing::Test {
 protected:
  auto factor() const { return landmarkFactor(pose_, landmark_, sighting_, bias_, 0.03); }

  Pose2 pose_{1.0, 2.0, 0.4};
  Vec2 landmark_{9.0, 7.5};
  Sighting sighting_{0.2, 9.5, 0.01, 0.2, 0};
  double bias_ = 0.0;
};

TEST_F(LandmarkFactorTest, SlopesAreThoseOfTheResidual) {
  std::vector<Change> unknowns = unknownsOf(pose_);
  unknowns.push_back(unknown(landmark_.x()));
  unknowns.push_back(unknown(landmark_.y()));
  unknowns.push_back(unknown(bias_));
  expectSlopes(factor().jacobian, unknowns, [&]() -> Eigen::VectorXd { return factor().residual; });
}

TEST_F(LandmarkFactorTest, ASightingOfSomethingElseWeighsLittle) {
  sighting_.bearing = std::atan2(5.5, 8.0) - pose_.heading;
  sighting_.range = std::hypot(5.5, 8.0);
  const Eigen::Vector2d right = factor().weight;
  sighting_.range += 4.0;
  EXPECT_LT(factor().weight[0], 0.02 * right[0]);
  EXPECT_LT(factor().weight[1], 0.02 * right[1]);
  EXPECT_GT(factor().weight[1], 0.0);
}

TEST_F(LandmarkFactorTest, AThingAtTheRobotIsNoInfinity) {
  landmark_ = pose_.position();
  EXPECT_TRUE(factor().jacobian.allFinite());
  EXPECT_TRUE(factor().residual.allFinite());
}

}  // namespace
}  // namespace handmap
