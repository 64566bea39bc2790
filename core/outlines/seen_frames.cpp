#include "core/outlines/seen_frames.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/outlines/constants.h"

namespace handmap {

using namespace outlines;

namespace {

std::size_t bearingBin(float bearing) {
  const double share = (static_cast<double>(bearing) + kPi) / (2.0 * kPi);
  return std::min(static_cast<std::size_t>(share * kBearings), kBearings - 1);
}

Echo echoAt(float height) {
  if (height > kHighest_m) return Echo::Ground;
  return height >= kTall_m ? Echo::Tall : height >= kLow_m ? Echo::Low : Echo::Ground;
}

void shareOut(std::vector<SeenRay>& rays) {
  std::array<std::array<int, kBearings>, 4> count{};
  for (const SeenRay& ray : rays) {
    ++count[static_cast<std::size_t>(ray.echo)][bearingBin(ray.bearing)];
  }
  for (SeenRay& ray : rays) {
    ray.share = 1.0F / static_cast<float>(
                           count[static_cast<std::size_t>(ray.echo)][bearingBin(ray.bearing)]);
  }
}

}  // namespace

void SeenFrames::add(std::size_t observation, const Pose2& odometry, const Scan& scan,
                     const std::vector<RangePoint>& points) {
  for (const float bearing : scan.first_looked_at) {
    const auto limit = static_cast<float>(range_limit_m_);
    for (SeenFrame& frame : frames_) frame.rays.push_back({bearing, limit, 1.0F, Echo::Silent});
  }
  const Pose2 motion = between(last_, odometry);
  const double driven = std::hypot(motion.x, motion.y);
  if (!frames_.empty() && driven < step_m_ && std::abs(motion.heading) < kFrameTurn) return;
  SeenFrame frame{observation, {}};
  if (points.empty() || scan.ray_by_ray) {
    addScan(scan, frame);
  } else {
    const double metres =
        frames_.empty() ? 1.0 : std::clamp(driven, kFrameStep_m, kMostRays / kRaysPerMetre);
    addPoints(points, kRaysPerMetre * metres * kFrameStep_m / step_m_, frame);
  }
  shareOut(frame.rays);
  last_ = odometry;
  rays_ += frame.rays.size();
  frames_.push_back(std::move(frame));
  if (rays_ > most_rays_) thinOut();
}

void SeenFrames::thinOut() {
  step_m_ *= 2.0;
  rays_ = 0;
  std::vector<SeenFrame> kept;
  for (std::size_t i = 0; i < frames_.size(); i += 2) {
    rays_ += frames_[i].rays.size();
    kept.push_back(std::move(frames_[i]));
  }
  frames_ = std::move(kept);
}

void SeenFrames::addScan(const Scan& scan, SeenFrame& frame) {
  for (const Ray& ray : scan.rays) {
    const bool silent = static_cast<double>(ray.range) > kSilent * range_limit_m_;
    const Echo echo = ray.returned ? Echo::Tall : silent ? Echo::Silent : Echo::Ground;
    frame.rays.push_back({ray.bearing, ray.range, 1.0F, echo});
  }
}

void SeenFrames::addPoints(const std::vector<RangePoint>& points, double most, SeenFrame& frame) {
  const auto stride =
      static_cast<std::size_t>(std::max(1.0, std::ceil(static_cast<double>(points.size()) / most)));
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const RangePoint& p = points[i];
    const float range = std::hypot(p.x, p.y);
    if (!std::isfinite(p.z) || !std::isfinite(range) || range < kLeastRange_m) continue;
    frame.rays.push_back({std::atan2(p.y, p.x), range, 1.0F, echoAt(p.z)});
  }
}

}  // namespace handmap
