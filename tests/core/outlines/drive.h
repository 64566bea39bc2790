// A drive of a range sensor past outlines, for tests: what it sees, without a simulator.
#pragma once

#include <cmath>
#include <limits>

#include "core/base/random.h"
#include "core/geometry/polygon.h"
#include "core/outlines/seen_frames.h"

namespace handmap {

/// How far a ray gets to a polygon; infinite where it passes.
inline double distanceAlong(const Vec2& from, const Vec2& direction, const Polygon& polygon) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2 along = polygon[(i + 1) % polygon.size()] - a;
    const double across = cross(direction, along);
    if (std::abs(across) < 1e-12) continue;
    const double distance = cross(a - from, along) / across;
    const double share = cross(a - from, direction) / across;
    if (distance > 0.0 && share >= 0.0 && share <= 1.0) nearest = std::min(nearest, distance);
  }
  return nearest;
}

struct Drive {
  SeenFrames seen{40.0};
  std::vector<Pose2> way;
};

/// Along x from 0 to 60 m, a scan of a degree a metre, σ of 0.03 m; hedges are seen ragged.
inline Drive drivePast(const std::vector<Polygon>& houses,
                       const std::vector<Polygon>& hedges = {}) {
  constexpr double kLimit_m = 40.0;
  Drive drive;
  RandomStream random(7);
  for (int i = 0; i <= 60; ++i) {
    const Pose2 pose{static_cast<double>(i), 0.0, 0.0};
    Scan scan;
    scan.ray_by_ray = true;
    for (int degree = -179; degree <= 180; ++degree) {
      const double bearing = toRadians(degree);
      const Vec2 direction = unitVector(bearing);
      double range = std::numeric_limits<double>::infinity();
      for (const Polygon& house : houses) {
        range = std::min(range, distanceAlong(pose.position(), direction, house));
      }
      range += random.normal(0.0, 0.03);
      for (const Polygon& hedge : hedges) {
        const double there = distanceAlong(pose.position(), direction, hedge);
        if (there < range) range = there + random.uniform(0.0, 1.5);
      }
      const bool returned = range < kLimit_m;
      scan.rays.push_back({static_cast<float>(bearing),
                           static_cast<float>(returned ? range : kLimit_m), 0.03F, 1.0F, returned});
    }
    drive.seen.add(drive.way.size(), pose, scan, {});
    drive.way.push_back(pose);
  }
  return drive;
}

inline Polygon moved(const Polygon& polygon, const Vec2& by) {
  Polygon result = polygon;
  for (Vec2& corner : result) corner += by;
  return result;
}

}  // namespace handmap
