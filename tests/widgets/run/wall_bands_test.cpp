#include "widgets/run/overlays/wall_bands.h"

#include <gtest/gtest.h>

#include "core/map/certainty.h"

namespace handmap {
namespace {

Building building(double heading) {
  Building building;
  building.shape = Rectangle{{10.0, 20.0}, 8.0, 4.0, heading};
  building.estimate = Estimate{3.0, 0.5, 8.0, 7};
  setSides(building, {{{0.5, true}, {0.25, true}, {3.0, false}, {1.0, true}}});
  return building;
}

TEST(WallBands, EachWallThatWasSeenHasTheBandOfItsOwnSigma) {
  const std::vector<Polygon> bands = wallBands(building(0.0));
  ASSERT_EQ(bands.size(), 3U) << "nobody saw the left wall";
  double widest = 0.0;
  double narrowest = 1e9;
  for (const Polygon& band : bands) {
    const Bounds bounds = boundsOf(band);
    const double width = (bounds.high - bounds.low).minCoeff();
    widest = std::max(widest, width);
    narrowest = std::min(narrowest, width);
    EXPECT_GT(bounds.low.x(), 5.0) << "around a wall that nobody saw there is none";
  }
  EXPECT_NEAR(widest, 2.0, 1e-9);
  EXPECT_NEAR(narrowest, 0.5, 1e-9);
}

TEST(WallBands, ASigmaLargerThanTheBuildingStillHasABand) {
  Building unsure = building(0.0);
  setSides(unsure, {{{9.0, true}, {9.0, true}, {9.0, true}, {9.0, true}}});
  const std::vector<Polygon> bands = wallBands(unsure);
  ASSERT_EQ(bands.size(), 4U);
  for (const Polygon& band : bands) EXPECT_GT(std::abs(signedArea(band)), 1.0);
}

TEST(WallBands, NoEstimateNoBand) {
  Building drawn = building(0.0);
  drawn.estimate.reset();
  EXPECT_TRUE(wallBands(drawn).empty());
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
