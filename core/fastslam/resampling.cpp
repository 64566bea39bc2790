#include "core/fastslam/resampling.h"

#include <numeric>

namespace handmap {

void normalize(std::vector<double>& weights) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  const double count = static_cast<double>(weights.size());
  for (double& weight : weights) weight = sum > 0.0 ? weight / sum : 1.0 / count;
}

double effectiveSampleSize(const std::vector<double>& weights) {
  return 1.0 / std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
}

std::vector<int> systematicResample(const std::vector<double>& weights, double offset) {
  const int count = static_cast<int>(weights.size());
  std::vector<int> drawn;
  drawn.reserve(weights.size());
  double reached = weights.front();
  int index = 0;
  for (int i = 0; i < count; ++i) {
    const double position = (i + offset) / count;
    while (position >= reached && index + 1 < count) {
      reached += weights[static_cast<std::size_t>(++index)];
    }
    drawn.push_back(index);
  }
  return drawn;
}

}  // namespace handmap
