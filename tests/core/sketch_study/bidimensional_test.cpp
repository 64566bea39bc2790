#include "core/sketch_study/bidimensional.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace handmap {
namespace {

/// Case 1 of Friedman & Kohler (2003), as published with T. Pingel's Matlab routine.
const std::vector<Vec2> kIndependent = {{0, 0}, {10, 0}, {8, 5}, {6, 5}};
const std::vector<Vec2> kDependent = {{12, 16}, {19, 19}, {21, 18}, {18, 14}};
/// Of the same rank as people's drawings: more places, and skewed.
const std::vector<Vec2> kFrom = {{3, 8}, {1, 1}, {7, -4}, {12, 3}, {-6, 2}, {0, -9}, {5, 5}};
const std::vector<Vec2> kTo = {{11, 18}, {14, 9}, {28, 6}, {31, 22}, {2, 3}, {20, -7}, {17, 15}};

/// By least squares over stacked equations, a row a coordinate.
Eigen::VectorXd stacked(const std::vector<Vec2>& from, const std::vector<Vec2>& to, bool affine) {
  const Eigen::Index rows = 2 * static_cast<Eigen::Index>(from.size());
  Eigen::MatrixXd design = Eigen::MatrixXd::Zero(rows, affine ? 6 : 4);
  Eigen::VectorXd values(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Vec2& x = from[static_cast<std::size_t>(i / 2)];
    const bool second = i % 2 == 1;
    values(i) = to[static_cast<std::size_t>(i / 2)][second ? 1 : 0];
    design(i, second ? 1 : 0) = 1.0;
    if (affine) {
      design.block<1, 2>(i, second ? 4 : 2) = x.transpose();
    } else {
      design(i, 2) = second ? x.y() : x.x();
      design(i, 3) = second ? x.x() : -x.y();
    }
  }
  Eigen::VectorXd solution = design.colPivHouseholderQr().solve(values);
  Eigen::VectorXd result(solution.size() + 1);
  result << solution, (design * solution - values).norm();
  return result;
}

TEST(BidimensionalRegression, IsTheLeastSquaresFit) {
  for (const auto& [from, to] : {std::pair(kIndependent, kDependent), std::pair(kFrom, kTo)}) {
    const auto euclidean = bidimensionalRegression(from, to, Transformation::Euclidean);
    const auto affine = bidimensionalRegression(from, to, Transformation::Affine);
    ASSERT_TRUE(euclidean && affine);
    const Eigen::VectorXd e = stacked(from, to, false);
    EXPECT_NEAR(euclidean->shift.x(), e(0), 1e-9);
    EXPECT_NEAR(euclidean->shift.y(), e(1), 1e-9);
    EXPECT_NEAR(euclidean->linear(0, 0), e(2), 1e-9);
    EXPECT_NEAR(euclidean->linear(1, 0), e(3), 1e-9);
    EXPECT_NEAR(euclidean->distortion, e(4), 1e-9);
    const Eigen::VectorXd a = stacked(from, to, true);
    EXPECT_NEAR((affine->shift - a.head<2>()).norm(), 0.0, 1e-9);
    EXPECT_NEAR((affine->linear.row(0).transpose() - a.segment<2>(2)).norm(), 0.0, 1e-9);
    EXPECT_NEAR((affine->linear.row(1).transpose() - a.segment<2>(4)).norm(), 0.0, 1e-9);
    EXPECT_NEAR(affine->distortion, a(6), 1e-9);
  }
}

/// Whichever side is taken as the independent one, the Euclidean index is the same: an index that
/// differs by an order between the two, as that of BiDimRegression 1.0.6 does, cannot be right.
TEST(BidimensionalRegression, DistortionIndexIsWhatTheFitLeaves) {
  const auto there = bidimensionalRegression(kFrom, kTo, Transformation::Euclidean);
  const auto back = bidimensionalRegression(kTo, kFrom, Transformation::Euclidean);
  ASSERT_TRUE(there && back);
  EXPECT_NEAR(std::pow(there->distortionIndex(), 2), 1.0 - there->r_squared, 1e-12);
  EXPECT_NEAR(there->distortionIndex(), back->distortionIndex(), 1e-12);
}

/// What BiDimRegression 2.0.1 prints for the data of Nakaya (1997): 19 places.
TEST(BidimensionalRegression, TestsAsPublishedForNakayasData) {
  const double left = 5.169255 / 83.680948;
  const FitTest test = testOf(Transformation::Euclidean, 1.0 - left, 19);
  EXPECT_NEAR(1.0 - left, 0.9382266, 1e-7);
  EXPECT_NEAR(test.f, 258.1994, 2e-4);
  EXPECT_EQ(test.model_df, 2);
  EXPECT_EQ(test.residual_df, 34);
  EXPECT_NEAR(test.aic, -101.8027, 1e-4);

  BidimensionalFit euclidean;
  euclidean.points = 19;
  euclidean.r_squared = 1.0 - left;
  BidimensionalFit affine = euclidean;
  affine.transformation = Transformation::Affine;
  affine.r_squared = 1.0 - left / (1.0 + 2.0 * 9.2189 / 32.0);
  affine.linear << 1.3220, -0.3715, 0.8189, 1.4350;
  EXPECT_NEAR(affine.test().f, 196.124, 1e-2);
  EXPECT_NEAR(affine.test().aic, -115.09, 5e-3);
  EXPECT_NEAR(affine.scaleX(), 1.555, 5e-4);
  EXPECT_NEAR(affine.scaleY(), 1.416, 5e-4);
  EXPECT_NEAR(affine.shear(), 0.311, 5e-4);
  EXPECT_NEAR(toDegrees(affine.theta()), 31.775, 2e-3);
  const FitTest better = testAgainst(euclidean, affine);
  EXPECT_NEAR(better.f, 9.2189, 1e-9);
  EXPECT_NEAR(better.p, 0.0006891, 1e-7);
  EXPECT_NEAR(better.aic, -13.29021, 1e-3);
}

TEST(BidimensionalRegression, FindsShiftTurnAndScale) {
  std::vector<Vec2> to;
  for (const Vec2& place : kFrom) to.push_back(2.0 * Pose2{5, -3, 0.4}.toOuter(place));
  const auto fit = bidimensionalRegression(kFrom, to, Transformation::Euclidean);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->theta(), 0.4, 1e-12);
  EXPECT_NEAR(fit->scaleX(), 2.0, 1e-12);
  EXPECT_NEAR(fit->scaleY(), 2.0, 1e-12);
  EXPECT_NEAR((fit->shift - Vec2(10, -6)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(fit->r(), 1.0, 1e-12);
}

TEST(BidimensionalRegression, NeedsPlacesThatDiffer) {
  const std::vector<Vec2> two = {{0, 0}, {1, 1}};
  EXPECT_FALSE(bidimensionalRegression(two, two, Transformation::Euclidean));
  const std::vector<Vec2> same(5, Vec2(3, 4));
  EXPECT_FALSE(bidimensionalRegression(same, kFrom, Transformation::Euclidean));
  const std::vector<Vec2> line = {{0, 0}, {1, 1}, {2, 2}, {3, 3}};
  EXPECT_TRUE(bidimensionalRegression(line, line, Transformation::Euclidean));
  EXPECT_FALSE(bidimensionalRegression(line, line, Transformation::Affine));
}

}  // namespace
}  // namespace handmap
