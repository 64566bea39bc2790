// How well a building explains the local map (paper, III): the cell values under its visible walls.
#pragma once

#include <algorithm>

#include "core/fastslam/building_model.h"
#include "core/fastslam/line_sums.h"
#include "core/fastslam/slam_options.h"

namespace handmap {

/// The sum discounted by the effective ratio: 0 where no cell is hit.
inline float discounted(const WallCells& cells, EffectiveRatio ratio) {
  if (cells.non_zero <= 0.0F) return 0.0F;
  const auto all = static_cast<float>(cells.all);
  // With no zero cell at all the ratio of the text has no value; one cell stands in.
  const float divisor = ratio == EffectiveRatio::ToAll ? all : std::max(all - cells.non_zero, 1.0F);
  return cells.sum * cells.non_zero / divisor;
}

/// One building model seen from one robot pose; scores any state of it. Walls are visible where
/// they face the robot and lie within the range of the local map; each is read at steps of one
/// cell. So that walls of one direction share their sums, the building is turned about its centre
/// to the nearest LineDirection, by an eighth of a degree at most.
class WallLikelihood {
 public:
  /// Keeps references to `model` and `sums`. `ahead` is unitVector(robot.heading).
  WallLikelihood(const BuildingModel& model, const Pose2& robot, const Vec2& ahead,
                 const LineSums& sums);

  /// `x` and `y` of the centre from the drawn one in the map frame, and the width, metres.
  WallCells operator()(float x, float y, float width) const;

 private:
  void addSlanted(float u0, float v0, float u1, float v1, WallCells& cells) const;

  const BuildingModel& model_;
  const LineSums& sums_;
  int steps_;  ///< the building's heading in the robot frame, in LineDirection::kStep
  LineDirection along_;
  LineDirection across_;
  float cells_per_m_;
  float ahead_x_, ahead_y_;  ///< the building's heading in the map frame, 1/cell
  float drawn_u_, drawn_v_;  ///< the drawn centre from the robot in the building's axes, cells
};

}  // namespace handmap
