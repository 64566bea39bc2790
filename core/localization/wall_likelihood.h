// How well a building explains the local map (paper, III): the cell values under its visible walls.
#pragma once

#include "core/localization/building_model.h"
#include "core/localization/slam_options.h"
#include "core/perception/local_map.h"

namespace handmap {

/// The cells under the visible walls of one building or of several.
struct WallCells {
  double sum = 0.0;  ///< of the cell values
  int non_zero = 0;
  int all = 0;

  WallCells& operator+=(const WallCells& other);
};

/// The sum discounted by the effective ratio: 0 where no cell is hit.
double discounted(const WallCells& cells, EffectiveRatio ratio);

/// One building model seen from one robot pose; scores any state of it.
class WallLikelihood {
 public:
  /// Keeps references to `model` and `local_map`.
  WallLikelihood(const BuildingModel& model, const Pose2& robot, const LocalMap& local_map);

  /// Walls are visible where they face the robot and lie within the range of the local map; each is
  /// read at steps of one cell.
  WallCells operator()(const BuildingState& state) const;

 private:
  WallCells alongWall(const Vec2& a, const Vec2& b) const;

  const BuildingModel& model_;
  const LocalMap& local_map_;
  Pose2 robot_;
  Vec2 along_;  ///< the building's axes in the robot frame
  Vec2 across_;
};

}  // namespace handmap
