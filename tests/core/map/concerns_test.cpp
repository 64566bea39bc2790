#include "core/map/concerns.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

Building house(const char* id, const Rectangle& box) {
  Building building;
  building.id = id;
  building.shape = box;
  building.estimate = Estimate{0.1, 0.1, 0.1, 5};
  return building;
}

/// Two houses with a gap of 2 m.
class ConcernsTest : public testing::Test {
 protected:
  ConcernsTest() {
    drawing_.uncertainty = {1.0, 1.0};
    drawing_.buildings = {house("A", {{0.0, 0.0}, 10.0, 10.0, 0.0}),
                          house("B", {{12.0, 0.0}, 10.0, 10.0, 0.0})};
    refined_ = drawing_;
  }
  Rectangle& box(std::size_t building) {
    return std::get<Rectangle>(refined_.buildings[building].shape);
  }
  std::vector<Concern> concerns() const { return concernsOf(drawing_, refined_); }

  Map drawing_;
  Map refined_;
};

TEST_F(ConcernsTest, WhatIsCorrectedAsTheDrawingMayBeOffIsNone) {
  box(0).centre += Vec2(-2.0, 1.0);
  box(1).width = 12.0;
  box(1).heading = toRadians(5.0);
  EXPECT_TRUE(concerns().empty());
}

TEST_F(ConcernsTest, BuildingsThatStandInEachOtherAreToldOfBoth) {
  box(0).centre.x() = 2.0;
  box(1).centre.x() = 8.0;
  const std::vector<Concern> found = concerns();
  ASSERT_GE(found.size(), 2U);
  EXPECT_EQ(found[0].kind, Concern::Kind::Overlaps);
  EXPECT_EQ(found[0].building, 0U);
  EXPECT_EQ(found[0].other, 1U);
  EXPECT_NEAR(found[0].by, 0.4, 1e-3);
  drawing_.buildings = refined_.buildings;  // as somebody drew them
  EXPECT_TRUE(concerns().empty());
}

TEST_F(ConcernsTest, FarMovedAndResizedAreToldAndTurnedIsNot) {
  box(0).centre.x() = -5.0;
  box(1) = {{12.0, 0.0}, 10.0, 19.0, toRadians(20.0)};
  const std::vector<Concern> found = concerns();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].kind, Concern::Kind::Moved);
  EXPECT_NEAR(found[0].by, 5.0, 1e-9);
  EXPECT_EQ(found[1].kind, Concern::Kind::Resized);
  EXPECT_NEAR(found[1].by, 9.0, 1e-6);
  box(1) = {{12.0, 0.0}, 10.0, 10.0, toRadians(20.0)};
  EXPECT_EQ(concerns().size(), 1U) << "people draw as much askew, and it is right";
  for (Building& building : refined_.buildings) building.estimate->observations = 0;
  EXPECT_TRUE(concerns().empty()) << "nobody saw them";
}

TEST_F(ConcernsTest, WhatIsFarFromItsDrawingOrAsThinAsAHedgeIsProbablySomethingElse) {
  const auto misfit = [&] {
    return misfitProbability(drawing_, drawing_.buildings[0], refined_.buildings[0]);
  };
  EXPECT_LT(misfit(), 0.01);
  box(0).centre.y() = 2.0;
  EXPECT_LT(misfit(), 0.05) << "a drawing may be off by two σ";
  box(0).width = 12.5;
  EXPECT_GT(misfit(), 0.05) << "and hardly its size as well";
  EXPECT_EQ(concerns().size(), 1U);
  box(0).centre.y() = 4.0;
  EXPECT_GT(misfit(), 0.3);
  box(0).centre.y() = 1e6;
  EXPECT_NEAR(misfit(), 1.0, 1e-6);
  box(0) = Rectangle{{0.0, -4.0}, 10.0, 3.0, 0.0};
  drawing_.uncertainty = {5.0, 5.0};
  EXPECT_GT(misfit(), 0.1);
  refined_.buildings[0].estimate.reset();
  EXPECT_EQ(misfit(), 0.0) << "nobody saw it";
}

}  // namespace
}  // namespace handmap
