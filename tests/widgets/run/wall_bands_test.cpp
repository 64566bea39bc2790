#include "widgets/run/wall_bands.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

Building building(double heading) {
  Building building;
  building.shape = Rectangle{{10.0, 20.0}, 8.0, 4.0, heading};
  building.estimate = Estimate{3.0, 0.5, 8.0, 7};
  return building;
}

TEST(WallBands, EndsOfTheWidthAreAsUnsureAsCentreAndHalfTheWidth) {
  const Building drawn = building(0.0);
  const Polygon footprint = drawn.footprint();
  const std::vector<double> sigmas = wallSigmas(drawn);
  ASSERT_EQ(sigmas.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 along = footprint[(i + 1) % 4] - footprint[i];
    const bool ends_the_width = std::abs(along.x()) < 1e-9;
    EXPECT_NEAR(sigmas[i], ends_the_width ? 5.0 : 0.5, 1e-12);  // 5² = 3² + (8 / 2)²
  }
}

TEST(WallBands, NoEstimateNoBand) {
  Building drawn = building(0.0);
  drawn.estimate.reset();
  EXPECT_EQ(wallSigmas(drawn), std::vector<double>(4, 0.0));
}

TEST(WallBands, WallsMoveAlongTheirNormals) {
  const Polygon footprint = building(0.3).footprint();
  const Polygon grown = offsetWalls(footprint, {1.0, 1.0, 1.0, 1.0});
  const Polygon shrunk = offsetWalls(footprint, {-1.0, -1.0, -1.0, -1.0});
  EXPECT_NEAR(signedArea(grown), 10.0 * 6.0, 1e-9);
  EXPECT_NEAR(signedArea(shrunk), 6.0 * 2.0, 1e-9);
}

TEST(WallBands, WallsThatWouldPassThroughEachOtherLeaveNothing) {
  const Polygon footprint = building(0.3).footprint();
  EXPECT_TRUE(offsetWalls(footprint, {-3.0, -3.0, -3.0, -3.0}).empty());
}

TEST(WallBands, ACornerInAStraightWallDoesNotRunAway) {
  const Polygon footprint = {{0, 0}, {5, 0}, {10, 0}, {10, 6}, {0, 6}};
  const Polygon grown = offsetWalls(footprint, std::vector<double>(5, 1.0));
  EXPECT_NEAR(signedArea(grown), 12.0 * 8.0, 1e-9);
}

}  // namespace
}  // namespace handmap
