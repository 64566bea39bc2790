#include "core/trajectory/scan_noise.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace handmap {
namespace {

/// Walls all around, 8 m off on one side and 28 m on the other.
std::vector<Vec2> scan(double near_sigma_m, double far_sigma_m, RandomStream& random) {
  std::vector<Vec2> returns;
  for (int i = 0; i < 360; ++i) {
    const bool near = i < 180;
    const double range = near ? random.normal(8.0, near_sigma_m) : random.normal(28.0, far_sigma_m);
    returns.push_back(range * unitVector(toRadians(i)));
  }
  return returns;
}

TEST(ScanNoise, IsFoundByDistance) {
  ScanNoise noise;
  RandomStream random(1);
  for (int i = 0; i < 20; ++i) noise.add(scan(0.05, 0.4, random));
  EXPECT_NEAR(noise.sigma(5.0), 0.05, 0.01);
  EXPECT_NEAR(noise.sigma(28.0), 0.4, 0.05);
  EXPECT_GT(noise.sigma(18.0), noise.sigma(8.0));
  EXPECT_LT(noise.sigma(18.0), noise.sigma(28.0));
  EXPECT_EQ(noise.sigma(60.0), noise.sigma(29.0));
}

TEST(ScanNoise, IsThatOfALaserBeforeMuchWasSeen) {
  ScanNoise noise;
  EXPECT_EQ(noise.sigma(10.0), 0.03);
  noise.add({});
  noise.add({{1, 0}, {1, 0}, {1, 0}});
  EXPECT_EQ(noise.sigma(10.0), 0.03);
}

}  // namespace
}  // namespace handmap
