// A box as one robot pose sees it: which rays can meet it, and where they do.
#pragma once

#include <vector>

#include "core/estimation/buildings/box.h"
#include "core/estimation/walls/frame.h"

namespace handmap {

/// Where a ray from outside enters a building.
struct Entry {
  float distance = 0.0F;  ///< < 0: it misses the box
  float cosine = 0.0F;    ///< of the angle of incidence
  int wall = 0;           ///< of Box::walls()
};

/// A robot pose in the frame of a box.
class BoxSlabs {
 public:
  BoxSlabs(const Box& box, const Pose2& robot);

  bool inside() const { return inside_; }  ///< the robot is in the building
  bool inBox() const { return nearest_ == 0.0F; }
  bool inReach(double range_m) const { return nearest_ < range_m; }
  Entry entry(const FrameRay& ray) const;

 private:
  Entry entryIntoOutline(float dx, float dy) const;

  float x_, y_;      ///< the robot
  float cos_, sin_;  ///< from the robot frame to that of the box
  float low_x_, high_x_, low_y_, high_y_;
  float nearest_;
  bool inside_;
  std::size_t corners_ = 0;  ///< of an outline
  std::array<float, kMostWalls> corner_x_;
  std::array<float, kMostWalls> corner_y_;
};

/// A box as one robot pose sees it.
class BoxView : public BoxSlabs {
 public:
  BoxView(const Box& box, const Pose2& robot);

  float lowBearing() const { return low_bearing_; }
  float highBearing() const { return high_bearing_; }
  /// Calls `use(ray)` for the rays within the bearings of the box.
  template <typename Use>
  void forRays(const std::vector<FrameRay>& rays, Use use) const {
    forRaysBetween(rays, low_bearing_, high_bearing_, use);
  }

 private:
  float low_bearing_;  ///< of the corners, robot frame; either may lie outside (-π, π]
  float high_bearing_;
};

/// How far a wall may be off against the poses, metres across the wall. Choice.
inline constexpr float kWallSlack = 0.05F;

}  // namespace handmap
