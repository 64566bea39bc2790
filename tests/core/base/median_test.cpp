#include "core/base/median.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

TEST(Median, IsTheMiddleOfTheSortedNumbers) {
  EXPECT_EQ(medianOf(std::vector{7.0, 1.0, 3.0}), 3.0);
  EXPECT_EQ(medianOf(std::vector{5.0F}), 5.0F);
}

TEST(Median, IsTheUpperOfTwoInTheMiddle) { EXPECT_EQ(medianOf(std::vector{4, 1, 3, 2}), 3); }

TEST(Median, IsZeroOfNone) { EXPECT_EQ(medianOf(std::vector<double>{}), 0.0); }

}  // namespace
}  // namespace handmap
