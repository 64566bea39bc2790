#include "core/estimation/smoothing/prior_factors.h"

#include "core/estimation/drawing/drawn_box.h"
#include "tests/core/estimation/smoothing/numeric.h"

namespace handmap {
namespace {

TEST(HeadingFactor, IsAgainstTheNearestDirectionOfTheDrawing) {
  const Box box = boxOf({{0.0, 0.0}, 20.0, 10.0, 0.45});
  const HeadingPrior prior{{0.4, 1.0}, 0.05};
  const ScalarFactor<1> factor = headingFactor(box, prior);
  EXPECT_NEAR(factor.residual, 0.05, 1e-12);
  EXPECT_NEAR(factor.weight, 400.0, 1e-9);
  Box turned = box;
  expectSlopes(factor.slope.transpose().eval(), {unknown(turned.heading)},
               [&]() -> Eigen::VectorXd {
                 return Eigen::VectorXd::Constant(1, headingFactor(turned, prior).residual);
               });
}

TEST(HeadingFactor, DirectionsAreTheSameAQuarterTurnOn) {
  const HeadingPrior prior{{0.1}, 0.05};
  const Box box = boxOf({{0.0, 0.0}, 20.0, 10.0, 0.12});
  EXPECT_NEAR(headingFactor(box.renumbered(1), prior).residual, 0.02, 1e-12);
}

TEST(HeadingFactor, ABuildingMayStandAsItLikes) {
  const HeadingPrior prior{{0.0}, 0.05};
  const ScalarFactor<1> factor = headingFactor(boxOf({{0.0, 0.0}, 20.0, 10.0, 0.5}), prior);
  EXPECT_NEAR(factor.residual, 0.1, 1e-12);  // no more than 2 σ
}

class DrawnWallsTest : public testing::Test {
 protected:
  DrawnWallsTest() {
    drawn_.shape = Rectangle{{30.0, 12.0}, 20.0, 10.0, 0.1};
    motion_.origin = {2.0, 1.0};
    motion_.mean = {1.05, 0.06, 1.5, -2.0};
    motion_.covariance = 0.01 * Eigen::Matrix4d::Identity();
    found_.box = boxOf({{33.0, 11.0}, 21.0, 9.5, 0.15});
    found_.covariance = 0.01 * Eigen::Matrix4d::Identity();
  }
  DrawnWallsFactor factor() const {
    return drawnWallsFactor(found_, SeenWalls(found_), {FoundId{0}, &drawn_, {3.0, 2.0}}, motion_);
  }
  Building drawn_;
  DrawingMotion motion_;
  FoundBox found_;
};

TEST_F(DrawnWallsTest, SlopesAreThoseOfThePrediction) {
  std::vector<Change> unknowns;
  for (Eigen::Index i = 0; i < 4; ++i) unknowns.push_back(unknown(motion_.mean[i]));
  const Eigen::Matrix4d by_motion = -factor().by_motion;
  // The sizes in the drawing change with the scale; that the frame of the box turns does not
  // matter.
  expectSlopes(
      by_motion, unknowns, [&]() -> Eigen::VectorXd { return factor().residual; }, 1e-5);
  for (std::size_t k = 0; k < 4; ++k) {
    const double before = factor().residual[static_cast<Eigen::Index>(k)];
    found_.box.reach[k] += 0.5;
    EXPECT_NEAR(factor().residual[static_cast<Eigen::Index>(k)], before + 0.5, 1e-12);
    found_.box.reach[k] -= 0.5;
  }
}

TEST_F(DrawnWallsTest, AWallThatNobodySawSaysNothing) {
  found_.setReachSigma(1, 10.0);
  EXPECT_LT(factor().weight(1, 1), 1e-5);
  EXPECT_GT(factor().weight(0, 0), 1e-3);
}

TEST_F(DrawnWallsTest, AWrongLabelWeighsLittle) {
  const double right = factor().weight(0, 0);
  found_.box.pivot += Vec2(80.0, 0.0);
  EXPECT_LT(factor().weight(0, 0), 0.15 * right);
}

TEST(KnownWalls, AreHeldAsWellAsTheyWereKnown) {
  FoundBox found{boxOf({{0.0, 0.0}, 20.0, 10.0, 0.0})};
  found.covariance = Eigen::Vector4d(1.0, 4.0, 1e-6, 9.0).asDiagonal();
  NormalEquations equations(5);
  addKnownWalls(found, 0, equations);
  const Eigen::VectorXd diagonal = Eigen::MatrixXd(equations.matrix()).diagonal();
  EXPECT_NEAR(diagonal[0], 1.0, 1e-12);
  EXPECT_NEAR(diagonal[1], 0.25, 1e-12);
  EXPECT_NEAR(diagonal[2], 1.0 / 0.09, 1e-9);  // no better than the poses that saw it
  EXPECT_EQ(diagonal[4], 0.0);
}

TEST(ReachDamping, HoldsTheSizeAndLetsTheWholeMove) {
  NormalEquations equations(5);
  addReachDamping(0, equations);
  const Eigen::MatrixXd lower = equations.matrix();
  const Eigen::MatrixXd matrix = lower.selfadjointView<Eigen::Lower>();
  Eigen::VectorXd grow = Eigen::VectorXd::Zero(5);
  grow[0] = grow[2] = 1.0;
  Eigen::VectorXd shift = Eigen::VectorXd::Zero(5);
  shift[0] = 1.0;
  shift[2] = -1.0;
  EXPECT_GT(grow.dot(matrix * grow), 50.0 * shift.dot(matrix * shift));
  EXPECT_GT(shift.dot(matrix * shift), 0.0);
  EXPECT_EQ(equations.right().norm(), 0.0);
}

}  // namespace
}  // namespace handmap
