// The reports of a run for the charts: never more than a fixed number of points, however long it
// is.
#pragma once

#include <optional>
#include <vector>

#include "core/method/snapshot.h"

namespace handmap {

/// When it is full, neighbours are averaged in pairs and from then on as many reports more make one
/// point.
class ReportSeries {
 public:
  static constexpr std::size_t kMostPoints = 512;

  /// `error_m`: of the position, where the truth is known.
  void add(const FrameReport& report, std::optional<double> error_m = {});
  void clear();

  /// All are means over the reports of a point.
  struct Point {
    double frame = 0.0;
    double time_s = 0.0;
    double effective_sample_size = 0.0;
    double spread_m = 0.0;        ///< certainWithin()
    double error_m = 0.0;         ///< NaN where the truth is not known
    double log_likelihood = 0.0;  ///< nats; NaN where no method tells it
    StageTimes ms;
  };
  const std::vector<Point>& points() const { return points_; }

 private:
  std::vector<Point> points_;
  Point gathering_;  ///< sums
  int gathered_ = 0;
  int reports_a_point_ = 1;
};

}  // namespace handmap
