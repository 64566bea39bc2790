#include "core/trajectory/scan_odometry_source.h"

#include <chrono>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/trajectory/local_map_odometry.h"
#include "core/trajectory/returns.h"

namespace handmap {

namespace {

class ScanOdometrySource : public ObservationSource {
 public:
  explicit ScanOdometrySource(std::unique_ptr<ObservationSource> source)
      : source_(std::move(source)), info_(source_->info()) {
    info_.odometry.clear();
  }

  const SourceInfo& info() const override { return info_; }

  std::optional<Observation> next() override {
    std::optional<Observation> observation = source_->next();
    if (!observation) return observation;
    const auto start = std::chrono::steady_clock::now();
    const auto points = allPoints(*observation);
    odometry_.add(observation->odometry, features(usableReturns(points, info_.range_limit_m)));
    observation->odometry = odometry_.pose();
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;
    observation->read_ms += spent.count();
    return observation;
  }

 private:
  std::unique_ptr<ObservationSource> source_;
  SourceInfo info_;
  LocalMapOdometry odometry_;
};

}  // namespace

std::vector<RangePoint> allPoints(const Observation& observation) {
  std::vector<RangePoint> points;
  for (const View& view : observation.views) {
    if (!view.points) {
      throwBadInput(phrase("frame {}", observation.frame), "", phrase("images"),
                    phrase("range points for odometry from scans"));
    }
    points.insert(points.end(), view.points->begin(), view.points->end());
  }
  return points;
}

std::unique_ptr<ObservationSource> withScanOdometry(std::unique_ptr<ObservationSource> source) {
  return std::make_unique<ScanOdometrySource>(std::move(source));
}

}  // namespace handmap
