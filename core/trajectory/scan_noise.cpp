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
  tell();
}

double ScanNoise::sigmaOf(const Histogram& histogram, int count) {
  const double quarter = 0.25 * count;
  double below = 0.0;
  std::size_t step = 0;
  while (below + histogram[step] < quarter) below += histogram[step++];
  const double within = (quarter - below) / std::max(histogram[step], 1);
  return kQuarterToSigma * kLeastOff_m *
         std::pow(10.0, (static_cast<double>(step) + within) / kStepsPerDecade);
}

void ScanNoise::tell() {
  told_.clear();
  double before = kLeastNoise_m;
  for (std::size_t bin = 0; bin < kRanges; ++bin) {
    if (counts_[bin] < kLeastCount) continue;
    before = std::max(sigmaOf(deviations_[bin], counts_[bin]), before);
    told_.push_back({kBin_m * (static_cast<double>(bin) + 0.5), before});
  }
}

double ScanNoise::sigma(double range_m) const {
  if (told_.empty()) return perception::kLaserSigma_m;
  const auto next = std::ranges::lower_bound(told_, range_m, {}, &Told::range_m);
  if (next == told_.begin()) return next->sigma_m;
  if (next == told_.end()) return told_.back().sigma_m;
  const Told& last = *std::prev(next);
  const double share = (range_m - last.range_m) / (next->range_m - last.range_m);
  return std::lerp(last.sigma_m, next->sigma_m, share);
}

}  // namespace handmap
