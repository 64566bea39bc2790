#include "core/pose_graph/normal_equations.h"

#include <limits>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace handmap {
namespace {

using Unknowns = NormalEquations::Unknowns;

/// Three unknowns, of which the equations tell all.
NormalEquations determined() {
  NormalEquations equations(3);
  Factor<2, 2> factor;
  factor.residual << 1.0, -2.0;
  factor.jacobian << 1.0, 2.0, 0.0, 1.0;
  factor.weight << 4.0, 1.0;
  equations.add(factor, std::array{Unknowns{2, 1}, Unknowns{0, 1}});
  equations.add(ScalarFactor<1>{0.5, Eigen::Matrix<double, 1, 1>::Ones(), 2.0},
                std::array{Unknowns{1, 1}});
  return equations;
}

TEST(NormalEquations, AreThoseOfDenseLeastSquares) {
  Eigen::Matrix3d jacobian;  // of unknowns 0, 1, 2
  jacobian << 2.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
  const Eigen::Vector3d weight(4.0, 1.0, 2.0);
  const Eigen::Vector3d residual(1.0, -2.0, 0.5);
  const Eigen::Matrix3d normal = jacobian.transpose() * weight.asDiagonal() * jacobian;
  const Eigen::Vector3d right = -jacobian.transpose() * weight.asDiagonal() * residual;
  NormalSolver solver;
  const auto step = solver.solve(determined());
  ASSERT_TRUE(step);
  EXPECT_LT((*step - normal.ldlt().solve(right)).norm(), 1e-12);
  ASSERT_TRUE(solver.isSolved());
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT((solver.covarianceColumn(i) - normal.inverse().col(i)).norm(), 1e-12);
  }
}

TEST(NormalEquations, UnknownsThatStayAreLeftOut) {
  NormalEquations equations(1);
  Factor<1, 2> factor;
  factor.residual << 3.0;
  factor.jacobian << 5.0, 1.0;
  factor.weight << 1.0;
  equations.add(factor, std::array{Unknowns{-1, 1}, Unknowns{0, 1}});
  NormalSolver solver;
  const auto step = solver.solve(equations);
  ASSERT_TRUE(step);
  EXPECT_NEAR((*step)[0], -3.0, 1e-12);
}

TEST(NormalSolver, WhatIsNotDeterminedIsDamped) {
  NormalEquations equations(2);
  Factor<1, 2> factor;  // one equation for two unknowns
  factor.residual << 2.0;
  factor.jacobian << 1.0, 1.0;
  factor.weight << 1.0;
  equations.add(factor, std::array{Unknowns{0, 1}, Unknowns{1, 1}});
  NormalSolver solver;
  const auto step = solver.solve(equations);
  ASSERT_TRUE(step);
  // The least step that takes the residual away.
  EXPECT_NEAR((*step)[0], -1.0, 1e-3);
  EXPECT_NEAR((*step)[1], -1.0, 1e-3);
}

TEST(NormalSolver, AnIndefiniteMatrixIsNoMinimum) {
  NormalEquations equations(2);
  equations.add(0, 0, 1.0);
  equations.add(1, 1, -0.5);
  equations.right({0, 2}) = Eigen::Vector2d(1.0, 1.0);
  NormalSolver solver;
  const auto step = solver.solve(equations);
  ASSERT_TRUE(step);
  EXPECT_GT((*step)[1], 0.0);  // damped until it goes downhill; undamped it went up
}

TEST(NormalSolver, NoNumberIsNoStep) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  NormalSolver solver;
  NormalEquations right = determined();
  right.right(1) = none;
  EXPECT_FALSE(solver.solve(right));
  EXPECT_FALSE(solver.isSolved());
  NormalEquations matrix = determined();
  matrix.add(2, 0, none);
  EXPECT_FALSE(solver.solve(matrix));
  NormalEquations endless = determined();
  endless.add(0, 0, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(solver.solve(endless));
  EXPECT_TRUE(solver.solve(determined()));
  EXPECT_TRUE(solver.isSolved());
}

}  // namespace
}  // namespace handmap
