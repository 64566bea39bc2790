#include "core/perception/perception.h"

#include <utility>

#include "core/base/error.h"
#include "core/perception/stereo_scan.h"
#include "core/perception/stopwatch.h"

namespace handmap {

Perception::Perception(const SourceInfo& source, const PerceptionOptions& options)
    : range_limit_m_(source.range_limit_m),
      range_walls_(source.range_limit_m, options.points),
      builder_(source.range_limit_m, options.local_map),
      scans_(source.range_limit_m) {
  if (!source.camera) return;
  std::optional<WallJudge> judge;
  if (options.classify) judge.emplace(options.classifier);
  stereo_.emplace(*source.camera, options.stereo, std::move(judge));
}

std::optional<Percept> Perception::operator()(const Observation& observation,
                                              const std::stop_token& stop) {
  std::vector<WallPoint> walls;
  std::vector<RangePoint> points;
  std::vector<Vec2> looked_through;
  StereoResult seen;
  cv::Mat image;
  double stereo_ms = 0.0;
  double classify_ms = 0.0;
  for (const View& view : observation.views) {
    if (stop.stop_requested()) return std::nullopt;
    std::vector<WallPoint> found;
    if (!view.left.empty() || !view.right.empty()) {
      if (!stereo_) throwBadInput("observation", "images", "no camera calibration", "one");
      seen = (*stereo_)(view.left, view.right, view.pan, range_limit_m_);
      image = view.left;
      stereo_ms += seen.stereo_ms;
      classify_ms += seen.walls_ms;
      found = std::move(seen.walls);
      looked_through.insert(looked_through.end(), seen.looked_through.begin(),
                            seen.looked_through.end());
    } else if (view.points) {
      const Stopwatch stopwatch;
      found = range_walls_(*view.points, observation.odometry);
      points.insert(points.end(), view.points->begin(), view.points->end());
      classify_ms += stopwatch.ms();
    } else {
      throwBadInput("observation", "view", "neither images nor points", "one of them");
    }
    walls.insert(walls.end(), found.begin(), found.end());
  }
  if (stop.stop_requested()) return std::nullopt;
  const Stopwatch stopwatch;
  Scan scan = image.empty() ? scans_(points, walls) : stereoScan(walls, looked_through);
  LocalMap map = builder_.add(observation.odometry, observation.standing, std::move(walls));
  return Percept{std::move(map), std::move(scan), image,       seen.disparity,
                 seen.buildings, stereo_ms,       classify_ms, stopwatch.ms()};
}

}  // namespace handmap
