#include "core/geometry/inner_point.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

TEST(InnerPoint, OfAnLIsWhereItIsWidest) {
  const Polygon thin_l = {{0, 0}, {60, 0}, {60, 12}, {6, 12}, {6, 60}, {0, 60}};
  EXPECT_FALSE(contains(thin_l, centroid(thin_l)));
  const Vec2 inside = innerPoint(thin_l);
  EXPECT_TRUE(contains(thin_l, inside));
  EXPECT_NEAR(inside.y(), 6.0, 1.5);
  for (std::size_t i = 0; i < thin_l.size(); ++i)
    EXPECT_GT(distanceTo(Segment{thin_l[i], thin_l[(i + 1) % 6]}, inside), 4.5);
}

TEST(InnerPoint, OfAConvexOutlineIsItsCentroid) {
  const Polygon outline = {{0, 0}, {30, 0}, {30, 10}, {0, 20}};
  EXPECT_EQ(innerPoint(outline), centroid(outline));
}

}  // namespace
}  // namespace handmap
