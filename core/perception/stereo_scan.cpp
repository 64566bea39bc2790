#include "core/perception/stereo_scan.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include <opencv2/core.hpp>

#include "core/perception/constants.h"

namespace handmap {

using namespace perception;

namespace {

int stereoDirection(double bearing) { return static_cast<int>(std::lround(bearing / kDirection)); }

}  // namespace

std::vector<Vec2> lookedThrough(const cv::Mat1f& disparity, const StereoCamera& camera,
                                const CameraRays& rays, double max_depth_m) {
  const double depth_disparity = camera.fx * camera.baseline;
  std::vector<Vec2> ends;
  std::vector<std::pair<double, double>> seen;  // level, forward
  cv::Mat1f by_columns;                         // so that a column lies in one piece of memory
  cv::transpose(disparity, by_columns);
  for (int column = 0; column < disparity.cols; ++column) {
    seen.clear();
    const float* disparities = by_columns[column];
    for (int row = 0; row < disparity.rows; ++row) {
      const double forward = rays.forward[static_cast<std::size_t>(row)];
      const double d = static_cast<double>(disparities[row]);
      if (d > 0.0 && forward > 0.0) seen.emplace_back(d / forward, forward);
    }
    if (seen.size() < kSupport) continue;
    const auto farthest = seen.begin() + kSupport - 1;
    std::nth_element(seen.begin(), farthest, seen.end());
    const double x = std::min(depth_disparity / farthest->first, max_depth_m);
    ends.emplace_back(x, x / farthest->second * rays.left[static_cast<std::size_t>(column)]);
  }
  return ends;
}

Scan stereoScan(const std::vector<WallPoint>& walls, const std::vector<Vec2>& looked_through) {
  std::map<int, Ray> by_direction;
  const auto put = [&](const Ray& ray, auto better) {
    const auto [kept, added] = by_direction.try_emplace(stereoDirection(ray.bearing), ray);
    if (!added && better(ray.range, kept->second.range)) kept->second = ray;
  };
  for (const WallPoint& wall : walls) {
    const Ray ray{std::atan2(wall.y, wall.x), std::hypot(wall.x, wall.y), wall.sigma, wall.weight,
                  true};
    put(ray, std::less<>());
  }
  for (const Vec2& end : looked_through) {
    const Ray ray{static_cast<float>(std::atan2(end.y(), end.x())), static_cast<float>(end.norm()),
                  0.0F, 0.0F, false};
    put(ray, [&](float range, float kept) {
      return !by_direction.at(stereoDirection(ray.bearing)).returned && range > kept;
    });
  }
  Scan scan;
  for (const WallPoint& wall : walls) {
    const double squared = wall.x * wall.x + wall.y * wall.y;
    scan.bias_sigma_per_m = std::max(scan.bias_sigma_per_m, wall.sigma / squared);
  }
  for (const auto& [direction, ray] : by_direction) scan.rays.push_back(ray);
  std::sort(scan.rays.begin(), scan.rays.end(),
            [](const Ray& a, const Ray& b) { return a.bearing < b.bearing; });
  return scan;
}

}  // namespace handmap
