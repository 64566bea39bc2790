// What a number of trials tells, and how surely: 95 % intervals.
#pragma once

#include <vector>

namespace handmap {

/// A value between the ends of its 95 % interval.
struct Interval {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// Share of successes with the score interval (Wilson, "Probable inference, the law of succession,
/// and statistical inference", 1927, eq. 9), which holds for few trials and near 0 and 1 too.
/// 0 … 1; without trials nothing is known: 0 between 0 and 1.
Interval wilsonInterval(int successes, int trials);

double meanOf(const std::vector<double>& values);  ///< 0 of none

/// Mean with the interval of the normal distribution; of one value or none: nothing but the value.
Interval meanInterval(const std::vector<double>& values);

/// Median with the distribution-free interval from order statistics: the ranks n/2 ± 1.96 √n/2,
/// rounded outwards (Conover, "Practical Nonparametric Statistics", 3.2); a few values: from the
/// least to the greatest. All 0 of none.
Interval medianInterval(std::vector<double> values);

}  // namespace handmap
