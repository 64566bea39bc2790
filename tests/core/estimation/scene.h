// A small scene for the tests: a robot beside boxes, seen with exact or noisy rays.
#pragma once

#include "core/base/random.h"
#include "core/estimation/buildings/box.h"
#include "core/estimation/walls/frame.h"

namespace handmap {

/// Distance along a ray to the nearest wall; negative where it misses. The plain way.
inline double plainDistance(const Box& box, const Vec2& origin, const Vec2& direction) {
  const Polygon corners = box.polygon();
  double nearest = -1.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 a = corners[i];
    const Vec2 along = corners[(i + 1) % corners.size()] - a;
    const double denominator = cross(direction, along);
    if (std::abs(denominator) < 1e-12) continue;
    const double distance = cross(a - origin, along) / denominator;
    const double share = cross(a - origin, direction) / denominator;
    if (distance < 0.0 || share < 0.0 || share > 1.0) continue;
    if (nearest < 0.0 || distance < nearest) nearest = distance;
  }
  return nearest;
}

inline Frame seenFrom(const Pose2& pose, const std::vector<Box>& boxes, double sigma,
                      RandomStream& random, int count = 720, double limit = 40.0) {
  Scan scan;
  for (int i = 0; i < count; ++i) {
    const double bearing = -kPi + 2.0 * kPi * (i + 1) / count;
    double range = limit;
    bool returned = false;
    for (const Box& box : boxes) {
      const double distance =
          plainDistance(box, pose.position(), unitVector(pose.heading + bearing));
      if (distance < 0.0 || distance > range) continue;
      range = distance;
      returned = true;
    }
    if (returned) range += random.normal(0.0, sigma);
    scan.rays.push_back({static_cast<float>(bearing), static_cast<float>(range), 0.0F,
                         returned ? 1.0F : 0.0F, returned});
  }
  return makeFrame(0.0, pose, pose, scan);
}

}  // namespace handmap
