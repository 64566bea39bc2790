#include "core/estimation/walls/frame.h"

#include "core/estimation/walls/constants.h"

namespace handmap {

using namespace walls;

namespace {

FrameRay rayAlong(float bearing, const Sight& sight) {
  return {std::cos(bearing), std::sin(bearing), bearing, sight};
}

}  // namespace

void addSilence(Frame& frame, const std::vector<float>& bearings, double range_limit_m) {
  const float range = kSilentUpTo * static_cast<float>(range_limit_m);
  for (const float bearing : bearings) {
    frame.rays.push_back(rayAlong(bearing, {range, kSilent}));
  }
  std::sort(frame.rays.begin(), frame.rays.end(),
            [](const FrameRay& a, const FrameRay& b) { return a.bearing < b.bearing; });
}

RayStretches raysBetween(const std::vector<FrameRay>& rays, float low, float high) {
  const auto whole = static_cast<float>(2.0 * kPi);
  const std::array turns = {-whole, 0.0F, whole};
  RayStretches stretches;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const float turn = turns[i];
    if (high + turn <= -whole / 2.0F || low + turn > whole / 2.0F) continue;
    const auto begin =
        std::lower_bound(rays.begin(), rays.end(), low + turn,
                         [](const FrameRay& ray, float bearing) { return ray.bearing < bearing; });
    const auto end =
        std::upper_bound(begin, rays.end(), high + turn,
                         [](float bearing, const FrameRay& ray) { return bearing < ray.bearing; });
    stretches[i] = {begin, end};
  }
  return stretches;
}

Frame makeFrame(double time_s, const Pose2& odometry, const Pose2& pose, const Scan& scan) {
  Frame frame;
  frame.time_s = time_s;
  frame.odometry = odometry;
  frame.pose = pose;
  frame.blind = scan.rays.empty();
  frame.bias_sigma_per_m = scan.bias_sigma_per_m;
  frame.ray_by_ray = scan.ray_by_ray;
  frame.rays.reserve(scan.rays.size());
  for (const Ray& ray : scan.rays) {
    const float range = ray.returned ? ray.range : kSilentUpTo * ray.range;
    const int label = ray.returned ? SensorModel::labelOf(ray.wall) : kSilent;
    frame.rays.push_back(rayAlong(ray.bearing, {range, label}));
  }
  return frame;
}

}  // namespace handmap
