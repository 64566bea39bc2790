#include "core/outlines/row_division.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/outlines/constants.h"

namespace handmap {
namespace {

using namespace outlines;

double nothing(double, double) { return 0.0; }

RowHouse house(double centre, double width) {
  RowHouse house;
  house.centre = centre;
  house.centre_sigma = 3.0;
  house.width = width;
  house.least_width = 3.0;
  house.most_width = 2.0 * width;
  return house;
}

TEST(RowDivision, GoesByWhatIsDrawnWhereNothingElseTells) {
  const auto parts =
      divideRow({house(4.0, 8.0), house(13.0, 9.0), house(26.0, 12.0)}, 0.0, 30.0, nothing);
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_NEAR(parts[0].to, 8.2, 1.0);
  EXPECT_NEAR(parts[1].to, 18.0, 1.0);
  EXPECT_EQ(parts[0].from, 0.0);
  EXPECT_EQ(parts[0].from_sigma, 0.0);
  EXPECT_GT(parts[0].to_sigma, 0.5);
  EXPECT_LT(parts[0].to_sigma, 3.0);
  EXPECT_EQ(parts[1].from, parts[0].to);
  EXPECT_EQ(parts[2].to, 30.0);
  EXPECT_EQ(parts[2].to_sigma, 0.0);
}

TEST(RowDivision, EndsAHouseAtAStep) {
  const auto stepped_at_10 = [](double from, double to) {
    return -4.0 * std::max(0.0, std::min(10.0 - from, to - 10.0));
  };
  const auto parts = divideRow({house(6.0, 12.0), house(16.0, 9.0)}, 0.0, 21.0, stepped_at_10);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_NEAR(parts[0].to, 10.0, 0.3);
  EXPECT_LT(parts[0].to_sigma, 0.5);
}

TEST(RowDivision, LeavesRoomForAHouseThatIsNotDrawn) {
  const auto parts = divideRow({house(5.0, 10.0), house(35.0, 10.0)}, 0.0, 40.0, nothing);
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[1].house, kUndrawn);
  EXPECT_NEAR(parts[1].from, 10.0, 3.0);
  EXPECT_NEAR(parts[1].to, 30.0, 3.0);
}

TEST(RowDivision, LeavesRoomForTwoThatAreNotDrawn) {
  const auto stepped_at_20 = [](double from, double to) {
    return -4.0 * std::max(0.0, std::min(20.0 - from, to - 20.0));
  };
  const auto parts = divideRow({house(5.0, 10.0), house(35.0, 10.0)}, 0.0, 40.0, stepped_at_20);
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[1].house, kUndrawn);
  EXPECT_NEAR(parts[1].from, 10.0, 3.0);
  EXPECT_NEAR(parts[1].to, 30.0, 3.0);
}

TEST(RowDivision, LeavesOutAHouseForWhichThereIsNoRoom) {
  RowHouse across = house(10.0, 10.0);
  across.nats = -9.0;
  const auto parts = divideRow({house(5.0, 10.0), across, house(15.0, 10.0)}, 0.0, 20.0, nothing);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].house, 0U);
  EXPECT_EQ(parts[1].house, 2U);
}

TEST(RowDivision, LeavesAHouseToItsOtherPlace) {
  RowHouse with_another = house(5.0, 10.0);
  with_another.worth_elsewhere = 6.0;
  const auto parts = divideRow({with_another, house(15.0, 12.0)}, 0.0, 14.0, nothing);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].house, 1U);
}

TEST(RowDivision, FindsARowThatIsDrawnOffAsAWhole) {
  const auto parts =
      divideRow({house(9.0, 10.0), house(19.0, 10.0), house(29.0, 10.0)}, 0.0, 30.0, nothing);
  ASSERT_EQ(parts.size(), 3U);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ(parts[i].house, i);
    EXPECT_NEAR(parts[i].to, 10.0 * static_cast<double>(i + 1), 1.5);
  }
}

TEST(RowDivision, SaysHowProbablyAHouseIsThatPart) {
  const auto stepped_at_10 = [](double from, double to) {
    return -4.0 * std::max(0.0, std::min(10.0 - from, to - 10.0));
  };
  const auto sure = divideRow({house(5.0, 10.0), house(15.0, 10.0)}, 0.0, 20.0, stepped_at_10);
  ASSERT_EQ(sure.size(), 2U);
  for (const RowPart& part : sure) EXPECT_GT(part.probability, 0.95);
  const auto either = divideRow({house(9.0, 10.0)}, 0.0, 20.0, stepped_at_10);
  ASSERT_EQ(either.size(), 2U);
  EXPECT_NEAR(either[0].to, 10.0, 0.3);
  for (const RowPart& part : either) EXPECT_NEAR(part.probability, 0.7, 0.1);
}

TEST(RowDivision, CountsWhatFitsNowhereForNoDivision) {
  const auto ragged = [](double from, double to) { return -500.0 * (to - from); };
  const std::vector<RowHouse> houses = {house(5.0, 10.0), house(15.0, 10.0)};
  const auto parts = divideRow(houses, 0.0, 20.0, ragged);
  const auto smooth = divideRow(houses, 0.0, 20.0, nothing);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_NEAR(parts[0].to, smooth[0].to, 1e-6);
}

TEST(RowDivision, HasNothingToDivideAmongNobody) {
  EXPECT_TRUE(divideRow({}, 0.0, 30.0, nothing).empty());
  EXPECT_TRUE(divideRow({house(5.0, 10.0)}, 0.0, 0.1, nothing).empty());
}

}  // namespace
}  // namespace handmap
