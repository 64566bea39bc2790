#include "core/geometry/polygon.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace handmap {
namespace {

const Polygon kSquare = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const Polygon kAngle = {{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 10}, {0, 10}};  // an L, 64 m²

Rectangle randomRectangle(RandomStream& random, double reach = 20.0) {
  return {{random.uniform(-reach, reach), random.uniform(-reach, reach)},
          random.uniform(1, 20),
          random.uniform(1, 20),
          random.uniform(-4, 4)};
}

TEST(Rectangle, HasCornersCounterClockwiseAlongItsHeading) {
  const Polygon corners = Rectangle{{10, 20}, 6, 2, kPi / 2}.corners();
  ASSERT_EQ(corners.size(), 4u);
  EXPECT_TRUE(corners[0].isApprox(Vec2(11, 17)));
  EXPECT_TRUE(corners[1].isApprox(Vec2(11, 23)));
  EXPECT_TRUE(corners[2].isApprox(Vec2(9, 23)));
  EXPECT_TRUE(corners[3].isApprox(Vec2(9, 17)));
  RandomStream random(1);
  for (int i = 0; i < 100; ++i) {
    const Rectangle r = randomRectangle(random);
    EXPECT_NEAR(signedArea(r.corners()), r.width * r.depth, 1e-9);
    EXPECT_TRUE(centroid(r.corners()).isApprox(r.centre, 1e-9));
  }
}

TEST(Polygon, AreaCentroidAndBounds) {
  EXPECT_DOUBLE_EQ(signedArea(kSquare), 16.0);
  EXPECT_DOUBLE_EQ(signedArea(kAngle), 64.0);
  Polygon clockwise = kSquare;
  std::reverse(clockwise.begin(), clockwise.end());
  EXPECT_DOUBLE_EQ(signedArea(clockwise), -16.0);
  EXPECT_TRUE(centroid(kSquare).isApprox(Vec2(2, 2)));
  EXPECT_TRUE(centroid(clockwise).isApprox(Vec2(2, 2)));
  // Two rectangles: 40 m² about (5, 2) and 24 m² about (2, 7).
  EXPECT_TRUE(centroid(kAngle).isApprox(Vec2(248.0 / 64.0, 248.0 / 64.0)));
  const Bounds bounds = boundsOf(kAngle);
  EXPECT_EQ(bounds.low, Vec2(0, 0));
  EXPECT_EQ(bounds.high, Vec2(10, 10));
}

TEST(Polygon, KnowsTheSimpleOnes) {
  EXPECT_TRUE(isSimple(kSquare));
  EXPECT_TRUE(isSimple(kAngle));
  EXPECT_TRUE(isSimple({{0, 0}, {5, 0}, {10, 0}, {10, 5}}));  // a corner on a straight wall
  Polygon clockwise = kAngle;
  std::reverse(clockwise.begin(), clockwise.end());
  EXPECT_TRUE(isSimple(clockwise));

  EXPECT_FALSE(isSimple({}));
  EXPECT_FALSE(isSimple({{0, 0}, {1, 0}}));
  EXPECT_FALSE(isSimple({{0, 0}, {1, 1}, {2, 2}}));                             // no area
  EXPECT_FALSE(isSimple({{0, 0}, {0.1, 0.1}, {0.3, 0.3}}));                     // none but rounding
  EXPECT_FALSE(isSimple({{0, 0}, {10, 0}, {0, 9}, {10, 10}}));                  // a bow tie
  EXPECT_FALSE(isSimple({{0, 0}, {4, 0}, {4, 4}, {0, 0}, {-4, -4}, {-4, 0}}));  // meets in a corner
  EXPECT_FALSE(isSimple({{0, 0}, {10, 0}, {10, 10}, {5, 10}, {5, 15}, {5, 10}, {0, 10}}));  // spike
  EXPECT_FALSE(isSimple({{0, 0}, {0, 0}, {4, 0}, {4, 4}}));  // a corner twice
  EXPECT_FALSE(isSimple({{0, 0}, {4, 0}, {4, 4}, {0, 0}}));  // closed by hand
}

TEST(Polygon, ContainsAndDistance) {
  EXPECT_TRUE(contains(kAngle, {1, 9}));
  EXPECT_TRUE(contains(kAngle, {9, 1}));
  EXPECT_FALSE(contains(kAngle, {9, 9}));
  EXPECT_FALSE(contains(kAngle, {-1, 4}));  // level with a corner
  EXPECT_FALSE(contains(kAngle, {11, 4}));
  EXPECT_DOUBLE_EQ(distanceTo(kAngle, Vec2(1, 9)), 0.0);
  EXPECT_DOUBLE_EQ(distanceTo(kAngle, Vec2(7, 6)), 2.0);
  EXPECT_DOUBLE_EQ(distanceTo(kAngle, Vec2(-3, -4)), 5.0);
  const Segment segment{{0, 0}, {10, 0}};
  EXPECT_DOUBLE_EQ(distanceTo(segment, {5, -2}), 2.0);
  EXPECT_DOUBLE_EQ(distanceTo(segment, {13, 4}), 5.0);
  EXPECT_DOUBLE_EQ(distanceTo(Segment{{1, 1}, {1, 1}}, {4, 5}), 5.0);
}

TEST(Polygon, IntersectionOfKnownShapes) {
  const Polygon shifted = {{2, 2}, {6, 2}, {6, 6}, {2, 6}};
  EXPECT_DOUBLE_EQ(intersectionArea(kSquare, shifted), 4.0);
  EXPECT_DOUBLE_EQ(intersectionOverUnion(kSquare, shifted), 4.0 / 28.0);
  EXPECT_DOUBLE_EQ(intersectionOverUnion(kSquare, kSquare), 1.0);
  EXPECT_DOUBLE_EQ(intersectionArea(kSquare, {{9, 9}, {12, 9}, {12, 12}}), 0.0);
  // The notch of the L, and a bar across both of its arms.
  EXPECT_DOUBLE_EQ(intersectionArea(kAngle, {{5, 5}, {9, 5}, {9, 9}, {5, 9}}), 0.0);
  EXPECT_NEAR(intersectionArea(kAngle, {{0, 2}, {2, 0}, {10, 8}, {8, 10}}), 14.0, 1e-9);
}

/// The share of random points in `a` that are also in `b`.
double sampledIntersection(const Rectangle& a, const Polygon& b, RandomStream& random) {
  constexpr int kPoints = 20'000;
  int hits = 0;
  const Pose2 frame{a.centre.x(), a.centre.y(), a.heading};
  for (int i = 0; i < kPoints; ++i) {
    const Vec2 p(random.uniform(-0.5, 0.5) * a.width, random.uniform(-0.5, 0.5) * a.depth);
    if (contains(b, frame.toOuter(p))) ++hits;
  }
  return a.width * a.depth * hits / kPoints;
}

TEST(Polygon, IntersectionAgreesWithSampling) {
  RandomStream random(2);
  for (int i = 0; i < 50; ++i) {
    const Rectangle a = randomRectangle(random, 8.0);
    const Rectangle b = randomRectangle(random, 8.0);
    const double area = intersectionArea(a.corners(), b.corners());
    EXPECT_NEAR(area, intersectionArea(b.corners(), a.corners()), 1e-4);
    EXPECT_NEAR(area, sampledIntersection(a, b.corners(), random), 0.02 * a.width * a.depth);
  }
}

TEST(Polygon, OverlapMeansCommonArea) {
  RandomStream random(3);
  int overlapping = 0;
  for (int i = 0; i < 500; ++i) {
    Polygon a = randomRectangle(random).corners();
    Polygon b = randomRectangle(random).corners();
    if (i % 3 == 0) {  // not convex
      const Rectangle frame = randomRectangle(random);
      b = kAngle;
      for (Vec2& p : b) p = Pose2{frame.centre.x(), frame.centre.y(), frame.heading}.toOuter(p);
    }
    const bool expected = intersectionArea(a, b) > 1e-9;
    EXPECT_EQ(overlap(a, b), expected) << i;
    EXPECT_EQ(overlap(b, a), expected) << i;
    overlapping += expected ? 1 : 0;
  }
  EXPECT_GT(overlapping, 50);
  EXPECT_LT(overlapping, 450);
}

TEST(Polygon, NeighboursThatShareAWallDoNotOverlap) {
  RandomStream random(4);
  for (int i = 0; i < 200; ++i) {
    const Rectangle a = randomRectangle(random);
    Rectangle b = a;
    b.width = random.uniform(1, 20);
    const Pose2 frame{a.centre.x(), a.centre.y(), a.heading};
    b.centre = frame.toOuter({(a.width + b.width) / 2.0, 0.0});
    EXPECT_FALSE(overlap(a.corners(), b.corners())) << i;
    b.centre = frame.toOuter({(a.width + b.width) / 2.0 - 0.001, 0.0});
    EXPECT_TRUE(overlap(a.corners(), b.corners())) << i;
  }
  EXPECT_FALSE(overlap(kAngle, {{4, 4}, {9, 4}, {9, 9}, {4, 9}}));  // fills the notch of the L
  EXPECT_TRUE(overlap(kAngle, {{3.9, 3.9}, {9, 4}, {9, 9}, {4, 9}}));
  EXPECT_TRUE(overlap(kSquare, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}));  // one inside the other
}

TEST(Polygon, BoundingRectangleHoldsAndTouches) {
  const Rectangle box = boundingRectangle(kAngle, kPi / 4.0);
  EXPECT_NEAR(box.width, 14.0 / std::sqrt(2.0), 1e-9);  // to (10, 4) and (4, 10)
  EXPECT_NEAR(box.depth, 20.0 / std::sqrt(2.0), 1e-9);
  RandomStream random(5);
  for (int i = 0; i < 100; ++i) {
    const Rectangle r = randomRectangle(random);
    const Rectangle same = boundingRectangle(r.corners(), r.heading);
    EXPECT_TRUE(same.centre.isApprox(r.centre, 1e-9));
    EXPECT_NEAR(same.width, r.width, 1e-9);
    EXPECT_NEAR(same.depth, r.depth, 1e-9);
  }
}

TEST(Polygon, PrincipalHeadingFollowsTheWalls) {
  RandomStream random(6);
  for (int i = 0; i < 200; ++i) {
    const double turn = random.uniform(-10, 10);
    Polygon turned = kAngle;
    for (Vec2& p : turned) p = Pose2{3, -5, turn}.toOuter(p);
    const double heading = principalHeading(turned);
    EXPECT_GE(heading, 0.0);
    EXPECT_LT(heading, kPi / 2.0);
    EXPECT_NEAR(std::remainder(heading - turn, kPi / 2.0), 0.0, 1e-9);
  }
  EXPECT_DOUBLE_EQ(principalHeading(kSquare), 0.0);
}

}  // namespace
}  // namespace handmap
