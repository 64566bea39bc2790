#include "core/method/pose_trust.h"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "core/base/random.h"

namespace handmap {
namespace {

TEST(PoseTrust, IsTheShareOfTheGaussianWithinTheDistance) {
  // Round: Rayleigh's distribution.
  const Eigen::Matrix2d round = Eigen::Vector2d(0.25, 0.25).asDiagonal();
  for (const double distance : {0.1, 0.5, 1.0, 2.0}) {
    EXPECT_NEAR(probabilityWithin(round, distance), 1.0 - std::exp(-2.0 * distance * distance),
                1e-3);
  }
  // Slanted and narrow: by counting.
  Eigen::Matrix2d slanted;
  slanted << 2.0, 1.9, 1.9, 2.0;
  const Eigen::Matrix2d root = slanted.llt().matrixL();
  RandomStream random(3);
  constexpr int kSamples = 100000;
  int within = 0;
  for (int i = 0; i < kSamples; ++i) {
    within += (root * Eigen::Vector2d(random.normal(), random.normal())).norm() <= 1.0 ? 1 : 0;
  }
  EXPECT_NEAR(probabilityWithin(slanted, 1.0), static_cast<double>(within) / kSamples, 5e-3);
  EXPECT_NEAR(probabilityWithin(Eigen::Matrix2d::Zero(), 1.0), 1.0, 1e-6);
  EXPECT_LT(probabilityWithin(1e12 * Eigen::Matrix2d::Identity(), 5.0), 1e-6);
}

TEST(PoseTrust, TellsOfTheBuildingsThatWereSeen) {
  Map map;
  for (int i = 0; i < 3; ++i) {
    Building building;
    building.id = std::to_string(i);
    building.shape = Rectangle{{0.0, 0.0}, 20.0, 10.0, kPi / 2.0};
    building.estimate = Estimate{0.1, 0.3, 0.8, i};
    map.buildings.push_back(building);
  }
  map.buildings[2].doubt = 0.5;
  const auto trust = trustOf(map);
  ASSERT_EQ(trust.size(), 2U);
  EXPECT_EQ(trust[0].building, 1U);
  EXPECT_NEAR(trust[0].sigma_m[0], 0.5, 1e-9);  // of a centre off by 0.3 m and a width by 0.8 m
  EXPECT_NEAR(trust[0].sigma_m[1], 0.1 * std::sqrt(2.0), 1e-9);
  EXPECT_EQ(trust[0].sigma_m[2], trust[0].sigma_m[0]);
  EXPECT_NEAR(trust[1].within, 0.5 * trust[0].within, 1e-9);
}

}  // namespace
}  // namespace handmap
