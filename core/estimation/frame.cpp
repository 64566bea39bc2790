#include "core/estimation/frame.h"

namespace handmap {

Frame makeFrame(double time_s, const Pose2& odometry, const Pose2& pose, const Scan& scan) {
  Frame frame;
  frame.time_s = time_s;
  frame.odometry = odometry;
  frame.pose = pose;
  frame.bias_sigma_per_m = scan.bias_sigma_per_m;
  frame.rays.reserve(scan.rays.size());
  for (const Ray& ray : scan.rays) {
    // Noise takes some of the returns near the limit beyond it: there silence says nothing.
    const float range = ray.returned ? ray.range : 0.9F * ray.range;
    const int label = ray.returned ? SensorModel::labelOf(ray.wall) : SensorModel::kSilent;
    frame.rays.push_back(
        {std::cos(ray.bearing), std::sin(ray.bearing), ray.bearing, {range, label}});
  }
  return frame;
}

}  // namespace handmap
