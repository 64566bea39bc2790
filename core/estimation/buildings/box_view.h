// A box as one robot pose sees it: which rays can meet it, and where they do.
#pragma once

#include <cmath>
#include <vector>

#include "core/estimation/buildings/box.h"
#include "core/estimation/buildings/constants.h"
#include "core/estimation/walls/frame.h"

namespace handmap {

/// Where a ray from outside enters a building.
struct Entry {
  float distance = -1.0F;  ///< < 0: it misses the box
  float cosine = 0.0F;     ///< of the angle of incidence
  int wall = 0;            ///< of the box
};

/// A robot pose in the frame of a box, however far that reaches.
struct PoseAtBox {
  PoseAtBox(const Box& box, const Pose2& robot);

  float x, y;
  float cos, sin;  ///< from the robot frame to that of the box
};

/// A box around a robot pose.
class BoxSlabs {
 public:
  BoxSlabs(const Box& box, const PoseAtBox& robot);
  BoxSlabs(const Box& box, const Pose2& robot) : BoxSlabs(box, PoseAtBox(box, robot)) {}

  bool inside() const { return nearest_ == 0.0F; }  ///< the robot is in the building
  bool inReach(double range_m) const { return nearest_ < range_m; }
  Entry entry(const FrameRay& ray) const;

 private:
  PoseAtBox robot_;
  float low_x_, high_x_, low_y_, high_y_;
  float nearest_;
};

// Asked more often than anything else: here, to be inlined.
inline Entry BoxSlabs::entry(const FrameRay& ray) const {
  const auto& [x_at, y_at, cos, sin] = robot_;
  const float dx = cos * ray.x - sin * ray.y;
  const float dy = sin * ray.x + cos * ray.y;
  Entry entry;
  if (x_at > high_x_ ? dx < 0.0F : x_at < low_x_ && dx > 0.0F) {
    const float distance = ((dx < 0.0F ? high_x_ : low_x_) - x_at) / dx;
    const float y = y_at + distance * dy;
    if (y >= low_y_ && y <= high_y_) entry = {distance, std::abs(dx), dx < 0.0F ? 0 : 2};
  }
  if (entry.distance < 0.0F && (y_at > high_y_ ? dy < 0.0F : y_at < low_y_ && dy > 0.0F)) {
    const float distance = ((dy < 0.0F ? high_y_ : low_y_) - y_at) / dy;
    const float x = x_at + distance * dx;
    if (x >= low_x_ && x <= high_x_) entry = {distance, std::abs(dy), dy < 0.0F ? 1 : 3};
  }
  return entry;
}

/// A box as one robot pose sees it.
class BoxView : public BoxSlabs {
 public:
  BoxView(const Box& box, const Pose2& robot);

  float lowBearing() const { return low_bearing_; }
  float highBearing() const { return high_bearing_; }
  /// Calls `use(ray)` for the rays within the bearings of the box.
  template <typename Use>
  void forRays(const std::vector<FrameRay>& rays, Use use) const {
    handmap::forRays(raysBetween(rays, low_bearing_, high_bearing_), use);
  }

 private:
  float low_bearing_;  ///< of the corners, robot frame; either may lie outside (-π, π]
  float high_bearing_;
};

}  // namespace handmap
