#include "widgets/run/panels/change_series.h"

#include <algorithm>
#include <numeric>

#include "core/map/map_changes.h"

namespace handmap {

void ChangeSeries::setDrawing(Map drawing) {
  drawing_ = std::move(drawing);
  drawn_.clear();
  for (const Building& building : drawing_.buildings) {
    drawn_.push_back(centroid(building.footprint()));
  }
  clear();
}

void ChangeSeries::add(double time_s, const Map& refined) {
  Moment moment;
  double errors = 0.0;
  int known = 0;
  for (std::size_t b = 0; b < std::min(drawn_.size(), refined.buildings.size()); ++b) {
    const Building& now = refined.buildings[b];
    moment.moved_m.push_back(static_cast<float>((centroid(now.footprint()) - drawn_[b]).norm()));
    const auto error = truth_ ? truth_->errorOf(now) : std::nullopt;
    if (!error) continue;
    errors += *error;
    ++known;
  }
  if (known > 0) moment.mean_error_m = errors / known;
  moments_[time_s] = std::move(moment);
  if (moments_.size() > kMostMoments) thin();
}

/// Every second goes; the first and the last stay.
void ChangeSeries::thin() {
  bool keep = true;
  for (auto at = moments_.begin(); std::next(at) != moments_.end();) {
    at = keep ? std::next(at) : moments_.erase(at);
    keep = !keep;
  }
}

std::vector<std::size_t> ChangeSeries::farthest(std::size_t most) const {
  std::vector<float> greatest(drawn_.size(), 0.0F);
  for (const auto& [time, moment] : moments_) {
    for (std::size_t b = 0; b < moment.moved_m.size(); ++b) {
      greatest[b] = std::max(greatest[b], moment.moved_m[b]);
    }
  }
  std::vector<std::size_t> order(greatest.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t b) { return greatest[b]; });
  std::erase_if(order,
                [&](std::size_t b) { return greatest[b] < static_cast<float>(kLeastMove_m); });
  if (order.size() > most) order.resize(most);
  return order;
}

}  // namespace handmap
