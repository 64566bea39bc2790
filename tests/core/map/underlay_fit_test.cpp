// Where a picture lies: by point pairs, by a length, by what its file says.
#include "core/map/underlay_fit.h"

#include <gtest/gtest.h>

#include "core/map/map_limits.h"
#include "core/map/tangent_plane.h"
#include "core/map/world_file.h"
#include "tests/core/base/expect_error.h"

namespace handmap {
namespace {

const Underlay kTurned{"plan.png", 12.0, -7.0, 0.25, toRadians(35.0), 0.5, {}};
const std::vector<Vec2> kPixels = {{0.0, 0.0}, {400.0, 20.0}, {130.0, 300.0}};

std::vector<PointPair> pairsOf(const Underlay& underlay, std::size_t count) {
  std::vector<PointPair> pairs;
  for (std::size_t i = 0; i < count; ++i)
    pairs.push_back({kPixels[i], pointOf(underlay, kPixels[i])});
  return pairs;
}

void expectSame(const Underlay& a, const Underlay& b, double tolerance = 1e-9) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.metres_per_pixel, b.metres_per_pixel, tolerance);
  EXPECT_NEAR(normalizedAngle(a.heading - b.heading), 0.0, tolerance);
}

TEST(UnderlayFit, PixelsGoDownAndTheMapUp) {
  const Underlay plain{"a.png", 10.0, 20.0, 0.5, 0.0, 1.0, {}};
  EXPECT_EQ(pointOf(plain, {4.0, 6.0}), Vec2(12.0, 17.0));
  EXPECT_EQ(pixelOf(plain, {12.0, 17.0}), Vec2(4.0, 6.0));
  for (const Vec2& pixel : kPixels)
    EXPECT_LT((pixelOf(kTurned, pointOf(kTurned, pixel)) - pixel).norm(), 1e-9);
}

TEST(UnderlayFit, TwoOrThreePairsFindTheSimilarity) {
  const Underlay before{"plan.png", 0.0, 0.0, 1.0, 0.0, 0.5, {}, {{"source", "\"city\""}}};
  for (const std::size_t count : {2u, 3u}) {
    const auto fit = fitted(before, pairsOf(kTurned, count));
    ASSERT_TRUE(fit);
    expectSame(fit->underlay, kTurned);
    EXPECT_LT(fit->residual, 1e-9);
    EXPECT_EQ(fit->underlay.image, "plan.png");
    EXPECT_EQ(fit->underlay.unknown, before.unknown) << "all else stays";
  }
}

TEST(UnderlayFit, ErrorsAreSharedAmongThePairs) {
  std::vector<PointPair> pairs = pairsOf(kTurned, 3);
  pairs[0].point += Vec2(1.0, 0.0);
  const auto fit = fitted(kTurned, pairs);
  ASSERT_TRUE(fit);
  EXPECT_GT(fit->residual, 0.1);
  EXPECT_LT(fit->residual, 1.0);
  // No other similarity nearby has a smaller sum of squares.
  const auto squares = [&](const Underlay& underlay) {
    double sum = 0.0;
    for (const PointPair& pair : pairs)
      sum += (pointOf(underlay, pair.pixel) - pair.point).squaredNorm();
    return sum;
  };
  const double least = squares(fit->underlay);
  for (double Underlay::*member :
       {&Underlay::x, &Underlay::y, &Underlay::metres_per_pixel, &Underlay::heading}) {
    for (const double step : {-1e-4, 1e-4}) {
      Underlay other = fit->underlay;
      other.*member += step;
      EXPECT_GT(squares(other), least);
    }
  }
}

TEST(UnderlayFit, WhatSaysNothingIsRefused) {
  EXPECT_FALSE(fitted(kTurned, {}));
  EXPECT_FALSE(fitted(kTurned, pairsOf(kTurned, 1)));
  const PointPair pair{{10.0, 10.0}, {1.0, 2.0}};
  EXPECT_FALSE(fitted(kTurned, std::vector{pair, PointPair{{10.0, 10.0}, {5.0, 2.0}}}));
  EXPECT_FALSE(fitted(kTurned, std::vector{pair, PointPair{{20.0, 10.0}, {1.0, 2.0}}}))
      << "no scale";
  EXPECT_FALSE(fitted(kTurned, std::vector{pair, PointPair{{11.0, 10.0}, {1e6, 2.0}}}));
  EXPECT_FALSE(scaled(kTurned, {1.0, 1.0}, {1.0, 1.0}, 5.0));
  EXPECT_FALSE(scaled(kTurned, {1.0, 1.0}, {2.0, 1.0}, 0.0));
  EXPECT_FALSE(scaled(kTurned, {1.0, 1.0}, {1.001, 1.0}, 1e5));
}

TEST(UnderlayFit, ALengthScalesAboutItsFirstPoint) {
  const Vec2 a = pointOf(kTurned, kPixels[0]);
  const Vec2 b = pointOf(kTurned, kPixels[1]);
  const auto larger = scaled(kTurned, a, b, 3.0 * (b - a).norm());
  ASSERT_TRUE(larger);
  EXPECT_LT((pointOf(*larger, kPixels[0]) - a).norm(), 1e-9);
  EXPECT_LT((pointOf(*larger, kPixels[1]) - (a + 3.0 * (b - a))).norm(), 1e-9);
}

TEST(UnderlayFit, AMapWithoutAPlaceIsGivenThatOfThePicture) {
  const Georeference there{34.7, 137.4, 0.0, {}};
  const TangentPlane plane(there);
  PictureGeometry geometry{PictureGeometry::Kind::LongitudeLatitude, {}};
  const Underlay truth{"aerial.tif", -60.0, 40.0, 0.2, toRadians(-2.0), 1.0, {}};
  for (const Vec2& pixel : {Vec2(0, 0), Vec2(600, 0), Vec2(600, 400), Vec2(0, 400)})
    geometry.pairs.push_back({pixel, plane.longitudeLatitude(pointOf(truth, pixel))});

  const auto known = grounded(truth, geometry, there, Vec2::Zero());
  ASSERT_TRUE(known);
  EXPECT_FALSE(known->georeference);
  expectSame(known->fit.underlay, truth, 1e-6);

  const auto new_place = grounded(truth, geometry, std::nullopt, {100.0, 50.0});
  ASSERT_TRUE(new_place && new_place->georeference);
  EXPECT_LT((pointOf(new_place->fit.underlay, {300.0, 200.0}) - Vec2(100.0, 50.0)).norm(), 1e-3);
  const TangentPlane given(*new_place->georeference);
  for (const PointPair& pair : geometry.pairs)
    EXPECT_LT((given.inMap(pair.point) - pointOf(new_place->fit.underlay, pair.pixel)).norm(),
              0.01);

  const Georeference elsewhere{-34.7, 20.0, 0.0, {}};
  EXPECT_FALSE(grounded(truth, geometry, elsewhere, Vec2::Zero())) << "another country";
}

TEST(WorldFile, SixNumbersPlaceThePixels) {
  const WorldFile file = parseWorldFile("0.5\n0\n0\n-0.5\n1000.25\n2000.75\n", "a.pgw");
  EXPECT_EQ(file.placeOf({0.0, 0.0}), Vec2(1000.0, 2001.0)) << "the corner of the first pixel";
  EXPECT_EQ(file.placeOf({10.0, 4.0}), Vec2(1005.0, 1999.0));
  PictureGeometry geometry;
  for (const Vec2& pixel : kPixels) geometry.pairs.push_back({pixel, file.placeOf(pixel)});
  const auto placed = grounded(kTurned, geometry, std::nullopt, {3.0, 4.0});
  ASSERT_TRUE(placed);
  EXPECT_FALSE(placed->georeference);
  EXPECT_NEAR(placed->fit.underlay.metres_per_pixel, 0.5, 1e-12);
  EXPECT_NEAR(placed->fit.underlay.heading, 0.0, 1e-12);
}

TEST(WorldFile, NonsenseIsRefusedWithItsPlace) {
  test::expectBadInput([] { parseWorldFile("0.5\n0\n0\n", "a.pgw"); },
                       {"a.pgw", "3 numbers", "six numbers"});
  test::expectBadInput([] { parseWorldFile("0.5\n0\nzero\n-1\n0\n0\n", "a.pgw"); },
                       {"line 3", "\"zero\""});
  test::expectBadInput([] { parseWorldFile("1e999\n0\n0\n-1\n0\n0\n", "a.pgw"); }, {"line 1"});
  test::expectBadInput([] { parseWorldFile("0\n0\n0\n0\n0\n0\n", "a.pgw"); }, {"without size"});
}

}  // namespace
}  // namespace handmap
