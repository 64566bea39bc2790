#include "core/estimation/buildings/outline_placement.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

Building lShape() {
  Building building;
  building.shape =
      Polygon{{0.0, 0.0}, {20.0, 0.0}, {20.0, 8.0}, {10.0, 8.0}, {10.0, 20.0}, {0.0, 20.0}};
  return building;
}

TEST(OutlineOf, IsThePolygonInItsBox) {
  const Building building = lShape();
  const std::shared_ptr<const Outline> outline = outlineOf(building);
  ASSERT_NE(outline, nullptr);
  Box box = boxOf(building.box());
  box.outline = outline;
  EXPECT_NEAR(intersectionOverUnion(box.polygon(), building.footprint()), 1.0, 1e-9);
  Building turned = building;
  std::reverse(std::get<Polygon>(turned.shape).begin(), std::get<Polygon>(turned.shape).end());
  EXPECT_GT(signedArea(Box{box.pivot, box.heading, box.reach, outlineOf(turned)}.polygon()), 0.0);
}

TEST(OutlineOf, IsNoneForARectangleOrManyCorners) {
  Building building;
  building.shape = Rectangle{{0.0, 0.0}, 10.0, 5.0, 0.0};
  EXPECT_EQ(outlineOf(building), nullptr);
  Polygon round;
  for (int i = 0; i < 40; ++i) round.push_back(10.0 * unitVector(i * kPi / 20.0));
  building.shape = round;
  EXPECT_EQ(outlineOf(building), nullptr);
}

TEST(Placements, ABoxMayBeTheWholeOrOneOfItsLegs) {
  const Building building = lShape();
  const Rectangle drawn = building.box();
  const Rectangle target{{50.0, 30.0}, 1.1 * drawn.width, 0.9 * drawn.depth, drawn.heading};
  const Polygon moved = building.fitted(target).footprint();
  const Polygon whole = building.footprint();
  const Polygon leg{{0.0, 0.0}, {20.0, 0.0}, {20.0, 8.0}, {0.0, 8.0}};
  const Polygon other_leg{{0.0, 0.0}, {10.0, 0.0}, {10.0, 20.0}, {0.0, 20.0}};
  for (Polygon part : {whole, leg, other_leg}) {
    for (Vec2& corner : part) corner = boxOf(target).at(boxOf(drawn).shareAt(corner));
    const Box found = boxOf(boundingRectangle(part, drawn.heading));
    double best = 0.0;
    for (const Box& box : placements(found, outlineOf(building), drawn)) {
      best = std::max(best, intersectionOverUnion(box.polygon(), moved));
    }
    EXPECT_GT(best, 0.999) << part.size();
  }
}

TEST(Placements, NoneIsStretchedBeyondBelief) {
  const Building building = lShape();
  const Box found = boxOf({{0.0, 0.0}, 60.0, 60.0, building.box().heading});
  EXPECT_TRUE(placements(found, outlineOf(building), building.box()).empty());
}

}  // namespace
}  // namespace handmap
