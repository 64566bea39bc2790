#include "drivers/camera/pair_matcher.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handmap {

std::optional<PairMatcher::Pair> PairMatcher::add(Side side, TimedImage image) {
  if (side == Side::Right) image.time_s -= right_delay_s_;
  auto& own = waiting_[side == Side::Left ? 0 : 1];
  auto& others = waiting_[side == Side::Left ? 1 : 0];
  const double time_s = image.time_s;
  const auto nearest =
      std::min_element(others.begin(), others.end(), [time_s](const auto& a, const auto& b) {
        return std::abs(a.time_s - time_s) < std::abs(b.time_s - time_s);
      });
  if (nearest != others.end()) {
    offset_s_ = side == Side::Right ? time_s - nearest->time_s : nearest->time_s - time_s;
  }
  if (nearest == others.end() || std::abs(nearest->time_s - time_s) > kTolerance_s) {
    own.push_back(std::move(image));
    if (own.size() > kMostWaiting) {
      own.pop_front();
      ++unmatched_;
    }
    return std::nullopt;
  }
  TimedImage other = std::move(*nearest);
  unmatched_ += static_cast<long>(own.size()) + std::distance(others.begin(), nearest);
  own.clear();
  others.erase(others.begin(), nearest + 1);
  if (side == Side::Right) return Pair{other.time_s, other.image, image.image};
  return Pair{time_s, image.image, other.image};
}

}  // namespace handmap
