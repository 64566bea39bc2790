// How well a box explains what was seen: the exact sum over rays.
#pragma once

#include <span>
#include <vector>

#include "core/estimation/box.h"
#include "core/estimation/frame.h"

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
  float x_, y_;      ///< the robot
  float cos_, sin_;  ///< from the robot frame to that of the box
  float low_x_, high_x_, low_y_, high_y_;
  float nearest_;
  bool inside_;

 private:
  Entry entryIntoOutline(float dx, float dy) const;

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

/// How far a wall may be off against the poses, metres across the wall.
inline constexpr float kWallSlack = 0.05F;

/// Scores boxes near a given one: finds once which frames and rays can meet them.
class BoxScorer {
 public:
  /// Looks at each `stride`-th ray: two take half the time for √2 of the noise.
  BoxScorer(const Box& box, std::span<const Frame* const> frames, const SensorModel& sensor,
            int stride = 2);

  /// Sum of the log likelihood ratios of all rays that would meet the box; very low where a robot
  /// stands inside it. The box may be any: far from the one given it only takes longer.
  double operator()(const Box& box);

 private:
  struct Looking {
    const Frame* frame;
    float low;  ///< bearings that can meet the boxes
    float high;
  };
  void lookAt(const Box& box);

  std::span<const Frame* const> frames_;
  const SensorModel& sensor_;
  int stride_;
  Box around_;
  std::vector<Looking> looking_;
};

}  // namespace handmap
