#include "core/perception/perception.h"

#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/stopwatch.h"
#include "core/perception/stereo_scan.h"

namespace handmap {

namespace {

/// Where the views of a stop overlap, the one that looks there most directly is taken, so that
/// nothing counts twice. Bearings of the robot frame; `yaw` is the camera's own.
class Overlaps {
 public:
  Overlaps(const std::vector<View>& views, double yaw) : views_(views), yaw_(yaw) {}

  void removeFrom(StereoResult& seen, std::size_t view) const {
    if (views_.size() == 1) return;
    std::erase_if(seen.walls, [&](const WallPoint& p) {
      return seenBetter(view, std::atan2(static_cast<double>(p.y), static_cast<double>(p.x)));
    });
    std::erase_if(seen.looked_through,
                  [&](const Vec2& p) { return seenBetter(view, std::atan2(p.y(), p.x())); });
  }

 private:
  double aside(std::size_t view, double bearing) const {
    return std::abs(normalizedAngle(bearing - yaw_ - views_[view].pan));
  }
  bool seenBetter(std::size_t view, double bearing) const {
    const double own = aside(view, bearing);
    for (std::size_t other = 0; other < views_.size(); ++other) {
      if (other == view || views_[other].left.empty()) continue;
      const double its = aside(other, bearing);
      if (its < own || (its == own && other < view)) return true;
    }
    return false;
  }

  const std::vector<View>& views_;
  double yaw_;
};

}  // namespace

Perception::Perception(const SourceInfo& source, const PerceptionOptions& options)
    : range_limit_m_(source.range_limit_m),
      range_walls_(source.range_limit_m, options.points),
      scans_(source.range_limit_m) {
  if (!source.camera) return;
  camera_yaw_ = source.camera->mount.yaw;
  std::optional<WallJudge> judge;
  if (options.classify) judge.emplace(options.classifier);
  stereo_.emplace(*source.camera, options.stereo, std::move(judge));
  if (!source.visual_odometry) odometry_.emplace(*source.camera);
}

/// What was guessed while nothing was recognised is made up for by the motion after it: neither is
/// told.
std::optional<Pose2> Perception::motionTo(const Observation& observation) {
  const Pose2 before = std::exchange(at_, observation.odometry);
  const bool from_followed = std::exchange(followed_, false);
  if (observation.standing || observation.views.size() != 1) return std::nullopt;
  const View& view = observation.views.front();
  if (view.left.empty() || view.right.empty()) return std::nullopt;
  if (!odometry_) {
    followed_ = !observation.odometry_guessed;
    return from_followed && followed_ ? std::optional(between(before, at_)) : std::nullopt;
  }
  const auto motion = (*odometry_)(view.left, view.right, observation.time_s, view.pan);
  followed_ = !motion || !motion->guessed;  // from the first pair on
  return motion && from_followed && followed_ ? std::optional(motion->motion) : std::nullopt;
}

std::optional<Percept> Perception::operator()(const Observation& observation,
                                              const std::stop_token& stop) {
  std::vector<WallPoint> walls;
  SeenPoints range;
  std::vector<Vec2> looked_through;
  StereoResult seen;
  cv::Mat image;
  double stereo_ms = 0.0;
  double classify_ms = 0.0;
  for (std::size_t i = 0; i < observation.views.size(); ++i) {
    const View& view = observation.views[i];
    if (stop.stop_requested()) return std::nullopt;
    std::vector<WallPoint> found;
    if (!view.left.empty() || !view.right.empty()) {
      if (!stereo_) {
        throwBadInput(phrase("observation"), phrase("images"), phrase("no camera calibration"),
                      phrase("one"));
      }
      seen = (*stereo_)(view.left, view.right, view.pan, range_limit_m_);
      Overlaps(observation.views, camera_yaw_).removeFrom(seen, i);
      image = view.left;
      stereo_ms += seen.stereo_ms;
      classify_ms += seen.walls_ms;
      found = std::move(seen.walls);
      looked_through.insert(looked_through.end(), seen.looked_through.begin(),
                            seen.looked_through.end());
    } else if (view.points) {
      const Stopwatch stopwatch;
      range.add(view);
      const bool only = observation.views.size() == 1;
      if (only) joined_.removeRepeats(range, observation.odometry);
      found = range_walls_(only ? range.points : *view.points, observation.odometry);
      classify_ms += stopwatch.ms();
    } else {
      throwBadInput(phrase("observation"), phrase("view"), phrase("neither images nor points"),
                    phrase("one of them"));
    }
    walls.insert(walls.end(), found.begin(), found.end());
  }
  if (stop.stop_requested()) return std::nullopt;
  const Stopwatch following;
  const std::optional<Pose2> moved = motionTo(observation);
  if (!image.empty()) stereo_ms += following.ms();
  const Stopwatch stopwatch;
  Scan scan = image.empty() ? scans_(range.points, walls) : stereoScan(walls, looked_through);
  classify_ms += stopwatch.ms();
  return Percept{std::move(walls),
                 std::move(scan),
                 std::move(range.points),
                 std::move(range.ids),
                 joined_.areJoined(),
                 moved,
                 image,
                 seen.disparity,
                 seen.buildings,
                 stereo_ms,
                 classify_ms};
}

}  // namespace handmap
