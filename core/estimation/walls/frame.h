// One observation as the estimator keeps it.
#pragma once

#include <algorithm>
#include <array>
#include <span>
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
  Pose2 odometry;                                     ///< odometry frame
  Eigen::Matrix3d guessed = Eigen::Matrix3d::Zero();  ///< see Odometry
  double odometry_noise = 1.0;  ///< σ of the motion to it, times that of OdometryNoise
  Pose2 pose;                   ///< map frame, best so far
  std::vector<FrameRay> rays;   ///< by bearing
  std::vector<Sighting> sightings;
  bool blind = false;             ///< the sensor was silent
  double bias_sigma_per_m = 0.0;  ///< as that of the scan
  bool ray_by_ray = false;        ///< the same
};

/// Adds that nothing came back to a frame along these bearings, up to the range limit.
void addSilence(Frame& frame, const std::vector<float>& bearings, double range_limit_m);

Frame makeFrame(double time_s, const Pose2& odometry, const Pose2& pose, const Scan& scan);

/// A stretch of neighbouring rays for each turn around the robot; some are empty.
using RayStretches = std::array<std::span<const FrameRay>, 3>;

/// The rays with bearings from `low` to `high`, either of which may lie up to a turn outside
/// (-π, π].
RayStretches raysBetween(const std::vector<FrameRay>& rays, float low, float high);

/// Calls `use(ray)` for each `stride`-th.
template <typename Use>
void forRays(const RayStretches& stretches, Use use, std::size_t stride = 1) {
  for (const std::span<const FrameRay> rays : stretches) {
    for (std::size_t i = 0; i < rays.size(); i += stride) use(rays[i]);
  }
}

}  // namespace handmap
