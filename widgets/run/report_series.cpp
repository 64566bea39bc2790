#include "widgets/run/report_series.h"

#include <array>

namespace handmap {

namespace {

using Point = ReportSeries::Point;

constexpr std::array kStages = {&StageTimes::read,      &StageTimes::stereo, &StageTimes::classify,
                                &StageTimes::local_map, &StageTimes::slam,   &StageTimes::total};

Point sum(Point a, const Point& b) {
  a.frame += b.frame;
  a.effective_sample_size += b.effective_sample_size;
  for (const auto stage : kStages) a.ms.*stage += b.ms.*stage;
  return a;
}

Point scaled(Point point, double factor) {
  point.frame *= factor;
  point.effective_sample_size *= factor;
  for (const auto stage : kStages) point.ms.*stage *= factor;
  return point;
}

}  // namespace

void ReportSeries::add(const FrameReport& report) {
  gathering_ =
      sum(gathering_, {static_cast<double>(report.frame), report.effective_sample_size, report.ms});
  if (++gathered_ < reports_a_point_) return;
  points_.push_back(scaled(gathering_, 1.0 / gathered_));
  gathering_ = {};
  gathered_ = 0;
  if (points_.size() < kMostPoints) return;
  for (std::size_t i = 0; i < points_.size() / 2; ++i) {
    points_[i] = scaled(sum(points_[2 * i], points_[2 * i + 1]), 0.5);
  }
  points_.resize(points_.size() / 2);
  reports_a_point_ *= 2;
}

void ReportSeries::clear() { *this = {}; }

}  // namespace handmap
