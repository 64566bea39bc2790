#include "core/sketch_study/pairwise.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

const std::vector<Vec2> kTruth = {{0, 0}, {4, 3}, {8, -6}};

TEST(PairwiseMeasures, APerfectDrawingOfAnyScaleHasNoErrors) {
  const PairwiseMeasures measures =
      pairwiseMeasures(kTruth, {Vec2(1, 1), Vec2(3, 2.5), Vec2(5, -2)});
  EXPECT_EQ(measures.missing, 0);
  EXPECT_DOUBLE_EQ(measures.canonical_organisation, 1.0);
  EXPECT_DOUBLE_EQ(measures.canonical_accuracy, 1.0);
  EXPECT_NEAR(measures.distance_accuracy, 1.0, 1e-12);
  EXPECT_NEAR(measures.scaling_bias, 0.0, 1e-12);
  EXPECT_NEAR(measures.angle_accuracy, 1.0, 1e-12);
  EXPECT_NEAR(measures.rotational_bias_rad, 0.0, 1e-12);
}

TEST(PairwiseMeasures, AMissingLandmarkCostsOrganisationNotAccuracy) {
  const PairwiseMeasures measures =
      pairwiseMeasures(kTruth, {Vec2(0, 0), Vec2(4, 3), std::nullopt});
  EXPECT_EQ(measures.missing, 1);
  EXPECT_NEAR(measures.canonical_organisation, 2.0 / 6.0, 1e-12);
  EXPECT_NEAR(measures.organisationRoot(), std::sqrt(1.0 / 3.0), 1e-12);
  EXPECT_DOUBLE_EQ(measures.canonical_accuracy, 1.0);
}

TEST(PairwiseMeasures, ATurnedDrawingHasARotationalBias) {
  std::vector<std::optional<Vec2>> drawn;
  for (const Vec2& place : kTruth) drawn.push_back(Pose2{1, 2, 0.5}.toOuter(place));
  const PairwiseMeasures measures = pairwiseMeasures(kTruth, drawn);
  EXPECT_NEAR(measures.rotational_bias_rad, 0.5, 1e-12);
  EXPECT_NEAR(measures.angle_accuracy, 1.0 - 0.5 / kPi, 1e-12);
  EXPECT_NEAR(measures.distance_accuracy, 1.0, 1e-12);
}

/// True distances 5, 10 and √97 are shares 0.5, 1 and 0.985 of the largest; 6, 10 and 8 drawn.
TEST(PairwiseMeasures, DistancesAreSharesOfTheLargest) {
  const PairwiseMeasures measures =
      pairwiseMeasures({{0, 0}, {5, 0}, {0, 10}}, {Vec2(0, 0), Vec2(6, 0), Vec2(0, 8)});
  const double most = std::sqrt(125.0);
  const double bias = ((6 - 5 * 10 / most) + (8 - 10 * 10 / most) + 0.0) / 30.0;
  EXPECT_NEAR(measures.scaling_bias, bias, 1e-12);
}

TEST(PairwiseMeasures, OneLandmarkTellsNothing) {
  const PairwiseMeasures measures = pairwiseMeasures({{0, 0}, {1, 1}}, {Vec2(0, 0), std::nullopt});
  EXPECT_EQ(measures.canonical_organisation, 0.0);
  EXPECT_EQ(measures.angle_accuracy, 0.0);
}

}  // namespace
}  // namespace handmap
