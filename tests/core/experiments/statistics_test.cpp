#include "core/experiments/statistics.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

void expectNear(const Interval& interval, double value, double low, double high) {
  EXPECT_NEAR(interval.value, value, 5e-5);
  EXPECT_NEAR(interval.low, low, 5e-5);
  EXPECT_NEAR(interval.high, high, 5e-5);
}

TEST(WilsonInterval, HasTheKnownValues) {
  expectNear(wilsonInterval(5, 10), 0.5, 0.2366, 0.7634);
  expectNear(wilsonInterval(8, 10), 0.8, 0.4902, 0.9433);
  expectNear(wilsonInterval(81, 263), 0.3080, 0.2553, 0.3662);  // Newcombe 1998, table I
  expectNear(wilsonInterval(15, 148), 0.1014, 0.0624, 0.1605);
  expectNear(wilsonInterval(1, 29), 0.0345, 0.0061, 0.1718);
}

TEST(WilsonInterval, EndsAtNothingAndAtAll) {
  expectNear(wilsonInterval(0, 20), 0.0, 0.0, 0.1611);
  expectNear(wilsonInterval(10, 10), 1.0, 0.7225, 1.0);
  for (int trials = 1; trials <= 200; ++trials) {
    EXPECT_EQ(wilsonInterval(0, trials).low, 0.0);
    EXPECT_EQ(wilsonInterval(trials, trials).high, 1.0);
  }
  expectNear(wilsonInterval(0, 0), 0.0, 0.0, 1.0);
}

TEST(MedianInterval, IsOfTheSortedValues) {
  expectNear(medianInterval({3.0, 1.0, 2.0}), 2.0, 1.0, 3.0);
  expectNear(medianInterval({4.0, 1.0, 3.0, 2.0}), 2.5, 1.0, 4.0);
  expectNear(medianInterval({7.0}), 7.0, 7.0, 7.0);
  expectNear(medianInterval({}), 0.0, 0.0, 0.0);
  std::vector<double> hundred;
  for (int i = 100; i >= 1; --i) hundred.push_back(i);
  expectNear(medianInterval(hundred), 50.5, 40.0, 61.0);  // the textbook's ranks
}

TEST(Mean, OfNoneIsZero) {
  EXPECT_EQ(meanOf({}), 0.0);
  EXPECT_EQ(meanOf({1.0, 2.0, 6.0}), 3.0);
}

}  // namespace
}  // namespace handmap
