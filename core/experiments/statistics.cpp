#include "core/experiments/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace handmap {

namespace {

constexpr double kZ = 1.959963984540054;  // normal quantile of 0.975

}  // namespace

Interval wilsonInterval(int successes, int trials) {
  if (trials <= 0) return {0.0, 0.0, 1.0};
  const double n = trials;
  const double share = successes / n;
  const double z2 = kZ * kZ;
  const double middle = (share + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half =
      kZ / (1.0 + z2 / n) * std::sqrt(share * (1.0 - share) / n + z2 / (4.0 * n * n));
  // Rounding must not leave the exact ends 0 and 1.
  return {share, successes == 0 ? 0.0 : middle - half, successes == trials ? 1.0 : middle + half};
}

double meanOf(const std::vector<double>& values) {
  if (values.empty()) return 0.0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Interval meanInterval(const std::vector<double>& values) {
  const double mean = meanOf(values);
  if (values.size() < 2) return {mean, mean, mean};
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const auto n = static_cast<double>(values.size());
  const double half = kZ * std::sqrt(squares / (n - 1.0) / n);
  return {mean, mean - half, mean + half};
}

Interval medianInterval(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto n = static_cast<double>(values.size());
  const auto ranked = [&](double rank) { return values[static_cast<std::size_t>(rank) - 1]; };
  const double middle = (n + 1.0) / 2.0;
  const double low = std::max(1.0, std::floor((n - kZ * std::sqrt(n)) / 2.0));
  const double median = (ranked(std::floor(middle)) + ranked(std::ceil(middle))) / 2.0;
  return {median, ranked(low), ranked(n + 1.0 - low)};
}

}  // namespace handmap
