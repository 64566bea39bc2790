#include "core/estimation/buildings/found_box.h"

namespace handmap {

void FoundBox::setReachSigma(std::size_t wall, double sigma) {
  const auto k = static_cast<Eigen::Index>(wall);
  covariance.row(k).setZero();
  covariance.col(k).setZero();
  covariance(k, k) = sigma * sigma;
}

bool FoundBox::predates(std::span<const Frame* const> frames) const {
  return first_frame + frames.size() < frames.front()->number;
}

FoundBox FoundBox::nearestTo(double heading_rad) const {
  const std::size_t quarters = box.quartersTo(heading_rad);
  FoundBox result = *this;
  result.box = box.renumbered(quarters);
  const auto from = [&](Eigen::Index k) { return (k + static_cast<Eigen::Index>(quarters)) % 4; };
  for (Eigen::Index i = 0; i < 4; ++i) {
    for (Eigen::Index j = 0; j < 4; ++j) result.covariance(i, j) = covariance(from(i), from(j));
  }
  return result;
}

}  // namespace handmap
