// One observation as the estimator keeps it.
#pragma once

#include <algorithm>
#include <vector>

#include "core/estimation/walls/sensor_model.h"
#include "core/geometry/pose2.h"
#include "core/perception/scan.h"

namespace handmap {

/// A direction of the robot frame and what was seen along it.
struct FrameRay {
  float x = 0.0F;  ///< unit vector
  float y = 0.0F;
  float bearing = 0.0F;  ///< (-π, π]
  Sight sight;
};

/// A compact thing seen from a frame, robot frame; σ of both.
struct Sighting {
  double bearing = 0.0;
  double range = 0.0;
  double bearing_sigma = 0.0;
  double range_sigma = 0.0;
  int landmark = -1;
};

struct Frame {
  std::size_t number = 0;  ///< of the frames kept, in order of time
  double driven_m = 0.0;   ///< driven since the first, by the odometry
  double time_s = 0.0;
  Pose2 odometry;               ///< odometry frame
  double odometry_noise = 1.0;  ///< σ of the motion to it, times that of OdometryNoise
  Pose2 pose;                   ///< map frame, best so far
  std::vector<FrameRay> rays;   ///< by bearing
  std::vector<Sighting> sightings;
  double bias_sigma_per_m = 0.0;  ///< as that of the scan
  bool ray_by_ray = false;        ///< the same
};

/// Adds that nothing came back to a frame along these bearings, up to the range limit.
void addSilence(Frame& frame, const std::vector<float>& bearings, double range_limit_m);

Frame makeFrame(double time_s, const Pose2& odometry, const Pose2& pose, const Scan& scan);

/// Calls `use(ray)` for the rays with bearings from `low` to `high`, either of which may lie up to
/// a turn outside (-π, π]; only each `stride`-th.
template <typename Use>
void forRaysBetween(const std::vector<FrameRay>& rays, float low, float high, Use use,
                    std::ptrdiff_t stride = 1) {
  constexpr auto kTurn = static_cast<float>(2.0 * kPi);
  const auto below = [](const FrameRay& ray, float bearing) { return ray.bearing < bearing; };
  for (const float turn : {-kTurn, 0.0F, kTurn}) {
    if (high + turn <= -kTurn / 2.0F || low + turn > kTurn / 2.0F) continue;
    auto ray = std::lower_bound(rays.begin(), rays.end(), low + turn, below);
    const auto end = std::upper_bound(
        ray, rays.end(), high + turn,
        [](float bearing, const FrameRay& other) { return bearing < other.bearing; });
    for (; ray < end; ray += std::min(stride, end - ray)) use(*ray);
  }
}

}  // namespace handmap
