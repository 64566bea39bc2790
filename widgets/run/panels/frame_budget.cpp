#include "widgets/run/panels/frame_budget.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace handmap {

namespace {

/// The value that a share of all is not above; `values` must not be empty.
double quantile(std::vector<double> values, double share) {
  const auto at = std::lround(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, values.begin() + at);
  return values[static_cast<std::size_t>(at)];
}

}  // namespace

void FrameBudget::add(const FrameReport& report) {
  if (frames_.size() == kMostFrames) frames_.pop_front();
  frames_.push_back({report.time_s, report.ms});
}

void FrameBudget::clear() { frames_.clear(); }

FrameBudget::Line FrameBudget::of(double StageTimes::*stage) const {
  if (frames_.empty()) return {};
  std::vector<double> values;
  double sum = 0.0;
  double all = 0.0;
  for (const Frame& frame : frames_) {
    values.push_back(frame.ms.*stage);
    sum += values.back();
    all += frame.ms.total;
  }
  return {all > 0.0 ? sum / all : 0.0, quantile(values, 0.5), quantile(values, 0.95)};
}

FrameBudget::Line FrameBudget::total() const { return of(&StageTimes::total); }

std::optional<double> FrameBudget::intervalMs() const {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < frames_.size(); ++i) {
    const double interval = frames_[i].time_s - frames_[i - 1].time_s;
    if (interval > 0.0) intervals.push_back(1000.0 * interval);
  }
  if (intervals.empty()) return std::nullopt;
  return quantile(std::move(intervals), 0.5);
}

}  // namespace handmap
