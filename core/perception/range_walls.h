// Range points to points on walls.
#pragma once

#include <vector>

#include "core/geometry/to_outer.h"
#include "core/perception/ground_height.h"
#include "core/perception/low_things.h"
#include "core/perception/wall_points.h"
#include "core/recording/observation.h"

namespace handmap {

/// Whether the sensor looks in one plane only: all heights are within 0.3 m.
bool isPlanar(const std::vector<RangePoint>& points);

/// Whether it does, or gives about one point a direction for other reasons: there is no vertical
/// structure to look for.
bool givesOneReturnADirection(const std::vector<RangePoint>& points);

/// A scan with vertical structure (a spinning lidar) is filtered by height and vertical extent in
/// cells of the plane; one with one return a direction is taken as it is. Remembers what was seen
/// to end low.
class RangeWalls {
 public:
  RangeWalls(double range_limit_m, const WallFilter& filter);

  /// `points` in the robot frame at `odometry`.
  std::vector<WallPoint> operator()(const std::vector<RangePoint>& points, const Pose2& odometry);

 private:
  /// What one scan shows in one cell of the plane, heights above ground.
  struct Column {
    float low;
    float high;
    int count;
  };

  std::vector<WallPoint> standing(const std::vector<RangePoint>& points, const Pose2& odometry);
  void add(const RangePoint& point, const GroundHeight& ground, const ToOuter& outer);
  bool isWall(const Column& column, const Vec2& at) const;

  float range_limit_m_;
  WallFilter filter_;
  PlaneCells cells_;
  std::vector<Column> columns_;
  LowThings low_things_;
};

}  // namespace handmap
