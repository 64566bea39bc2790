#include "widgets/run/panels/report_series.h"

#include <array>
#include <cmath>
#include <limits>

#include "core/method/pose_trust.h"

namespace handmap {

namespace {

using Point = ReportSeries::Point;

constexpr std::array kValues = {&Point::frame,    &Point::time_s,  &Point::effective_sample_size,
                                &Point::spread_m, &Point::error_m, &Point::log_likelihood};
constexpr std::array kTimes = {&StageTimes::read,      &StageTimes::stereo, &StageTimes::classify,
                               &StageTimes::local_map, &StageTimes::slam,   &StageTimes::total};

Point sum(Point a, const Point& b) {
  for (const auto value : kValues) a.*value += b.*value;
  for (const auto stage : kTimes) a.ms.*stage += b.ms.*stage;
  return a;
}

Point scaled(Point point, double factor) {
  for (const auto value : kValues) point.*value *= factor;
  for (const auto stage : kTimes) point.ms.*stage *= factor;
  return point;
}

Point pointOf(const FrameReport& report, std::optional<double> error_m) {
  return {static_cast<double>(report.frame),
          report.time_s,
          report.effective_sample_size,
          certainWithin(report),
          error_m.value_or(std::numeric_limits<double>::quiet_NaN()),
          report.log_likelihood.value_or(std::numeric_limits<double>::quiet_NaN()),
          report.ms};
}

}  // namespace

void ReportSeries::add(const FrameReport& report, std::optional<double> error_m) {
  gathering_ = sum(gathering_, pointOf(report, error_m));
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
