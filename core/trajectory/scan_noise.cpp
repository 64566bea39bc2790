#include "core/trajectory/scan_noise.h"

#include <algorithm>
#include <cmath>

#include "core/base/gaussian.h"
#include "core/trajectory/constants.h"

namespace handmap {

using namespace trajectory;

void ScanNoise::add(const std::vector<Vec2>& returns) {
  struct Return {
    double bearing;
    double range;
  };
  std::vector<Return> scan;
  scan.reserve(returns.size());
  for (const Vec2& p : returns) scan.push_back({std::atan2(p.y(), p.x()), p.norm()});
  std::sort(scan.begin(), scan.end(), [](const Return& a, const Return& b) {
    return a.bearing != b.bearing ? a.bearing < b.bearing : a.range < b.range;
  });
  for (std::size_t i = 1; i + 1 < scan.size(); ++i) {
    const double width = scan[i + 1].bearing - scan[i - 1].bearing;
    const double t = width > 0.0 ? (scan[i].bearing - scan[i - 1].bearing) / width : 0.5;
    const double line = scan[i - 1].range + t * (scan[i + 1].range - scan[i - 1].range);
    const double spread = std::sqrt(1.0 + t * t + (1.0 - t) * (1.0 - t));
    const double off = std::max(std::abs(scan[i].range - line) / spread, kLeastOff_m);
    const auto bin = std::min(static_cast<std::size_t>(scan[i].range / kBin_m), kRanges - 1);
    const auto step = static_cast<std::size_t>(kStepsPerDecade * std::log10(off / kLeastOff_m));
    ++deviations_[bin][std::min(step, kSteps - 1)];
    ++counts_[bin];
  }
}

double ScanNoise::median(const Histogram& histogram, int count) {
  int below = 0;
  std::size_t step = 0;
  while (2 * (below + histogram[step]) < count) below += histogram[step++];
  const double within = (0.5 * count - below) / std::max(histogram[step], 1);
  return kLeastOff_m * std::pow(10.0, (static_cast<double>(step) + within) / kStepsPerDecade);
}

double ScanNoise::sigma(double range_m) const {
  double before_m = 0.0;
  double before = 0.0;
  for (std::size_t bin = 0; bin < kRanges; ++bin) {
    if (counts_[bin] < kLeastCount) continue;
    const double middle_m = kBin_m * (static_cast<double>(bin) + 0.5);
    const double here =
        std::max({kMedianToSigma * median(deviations_[bin], counts_[bin]), kLeastNoise_m, before});
    if (range_m <= middle_m) {
      if (before == 0.0) return here;
      return before + (here - before) * (range_m - before_m) / (middle_m - before_m);
    }
    before_m = middle_m;
    before = here;
  }
  return before > 0.0 ? before : perception::kLaserSigma_m;
}

}  // namespace handmap
