#include "core/outlines/seen_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/odometry/constants.h"
#include "core/outlines/constants.h"
#include "core/perception/constants.h"
#include "core/perception/range_walls.h"

namespace handmap {

using namespace outlines;

namespace {

std::size_t bearingBin(float bearing) {
  const double share = (static_cast<double>(bearing) + kPi) / (2.0 * kPi);
  return std::min(static_cast<std::size_t>(share * kBearings), kBearings - 1);
}

Echo echoAt(float height) {
  if (height > perception::kHighest_m) return Echo::Ground;
  return height >= perception::kTall_m ? Echo::Tall : height >= kLow_m ? Echo::Low : Echo::Ground;
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

/// What images show that is rather no building counts as what is low.
std::vector<SeenRay> raysOf(const Scan& scan, double range_limit_m) {
  std::vector<SeenRay> rays;
  rays.reserve(scan.rays.size());
  for (const Ray& ray : scan.rays) {
    const bool silent = static_cast<double>(ray.range) > kSilent * range_limit_m;
    const bool tall = scan.ray_by_ray || showsWall(ray);
    const Echo returned = tall ? Echo::Tall : Echo::Low;
    const Echo echo = ray.returned ? returned : silent ? Echo::Silent : Echo::Ground;
    rays.push_back({ray.bearing, ray.range, 1.0F, echo});
  }
  return rays;
}

/// At most so many of what was measured.
std::vector<SeenRay> raysOf(const std::vector<RangePoint>& points, double most) {
  const auto stride =
      static_cast<std::size_t>(std::max(1.0, std::ceil(static_cast<double>(points.size()) / most)));
  const bool planar = isPlanar(points);  // how high that is tells nothing of what it met
  std::vector<SeenRay> rays;
  rays.reserve(points.size() / stride + 1);
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const RangePoint& p = points[i];
    const float range = std::hypot(p.x, p.y);
    if (!std::isfinite(p.z) || !std::isfinite(range) || range < kLeastRange_m) continue;
    rays.push_back({std::atan2(p.y, p.x), range, 1.0F, planar ? Echo::Tall : echoAt(p.z)});
  }
  return rays;
}

bool isElsewhere(const Pose2& before, const Pose2& now, double step_m) {
  const Pose2 motion = between(before, now);
  return motion.position().norm() >= step_m || std::abs(motion.heading) >= odometry::kKeyframeTurn;
}

}  // namespace

void SeenFrames::add(std::size_t observation, const Pose2& odometry, const Scan& scan,
                     const std::vector<RangePoint>& points) {
  if (!scan.first_looked_at.empty()) addSilent(scan.first_looked_at);
  if (!frames_.empty() && !isElsewhere(looked_, odometry, kFrameStep_m)) return;
  looked_ = odometry;
  looks_ += 1.0F;
  if (!frames_.empty() && !isElsewhere(last_, odometry, step_m_)) return;
  std::vector<SeenRay> rays;
  if (points.empty() || scan.ray_by_ray) {
    rays = raysOf(scan, range_limit_m_);
  } else {
    const double metres = frames_.empty() ? 1.0
                                          : std::clamp(between(last_, odometry).position().norm(),
                                                       kFrameStep_m, kMostRays / kRaysPerMetre);
    rays = raysOf(points, kRaysPerMetre * metres * kFrameStep_m / step_m_);
  }
  shareOut(rays);
  last_ = odometry;
  rays_ += rays.size();
  frames_.push_back({observation, std::make_shared<const std::vector<SeenRay>>(std::move(rays)),
                     std::exchange(looks_, 0.0F)});
  if (rays_ > most_rays_) thinOut();
}

void SeenFrames::addSilent(const std::vector<float>& bearings) {
  for (SeenFrame& frame : frames_) {
    auto rays = std::make_shared<std::vector<SeenRay>>(*frame.rays);
    for (const float bearing : bearings)
      rays->push_back({bearing, static_cast<float>(range_limit_m_), 1.0F, Echo::Silent});
    frame.rays = std::move(rays);
  }
}

void SeenFrames::thinOut() {
  step_m_ *= 2.0;
  rays_ = 0;
  std::vector<SeenFrame> kept;
  for (std::size_t i = 0; i < frames_.size(); i += 2) {
    rays_ += frames_[i].rays->size();
    if (i + 1 < frames_.size()) frames_[i].looks += frames_[i + 1].looks;
    kept.push_back(std::move(frames_[i]));
  }
  frames_ = std::move(kept);
}

}  // namespace handmap
