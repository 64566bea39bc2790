#include "core/estimation/walls/frame.h"

namespace handmap {

namespace {

/// Noise takes some of the returns near the limit beyond it: there silence says nothing. Choice.
constexpr float kSilentUpTo = 0.9F;

FrameRay rayAlong(float bearing, const Sight& sight) {
  return {std::cos(bearing), std::sin(bearing), bearing, sight};
}

}  // namespace

void addSilence(Frame& frame, const std::vector<float>& bearings, double range_limit_m) {
  const float range = kSilentUpTo * static_cast<float>(range_limit_m);
  for (const float bearing : bearings) {
    frame.rays.push_back(rayAlong(bearing, {range, SensorModel::kSilent}));
  }
  std::sort(frame.rays.begin(), frame.rays.end(),
            [](const FrameRay& a, const FrameRay& b) { return a.bearing < b.bearing; });
}

Frame makeFrame(double time_s, const Pose2& odometry, const Pose2& pose, const Scan& scan) {
  Frame frame;
  frame.time_s = time_s;
  frame.odometry = odometry;
  frame.pose = pose;
  frame.bias_sigma_per_m = scan.bias_sigma_per_m;
  frame.ray_by_ray = scan.ray_by_ray;
  frame.rays.reserve(scan.rays.size());
  for (const Ray& ray : scan.rays) {
    const float range = ray.returned ? ray.range : kSilentUpTo * ray.range;
    const int label = ray.returned ? SensorModel::labelOf(ray.wall) : SensorModel::kSilent;
    frame.rays.push_back(rayAlong(ray.bearing, {range, label}));
  }
  return frame;
}

}  // namespace handmap
