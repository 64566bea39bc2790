// What a swarm particle stands for: a building moved to x, y and stretched to a width.
#pragma once

#include <cmath>
#include <vector>

#include "core/map/map.h"

namespace handmap {

/// The three parameters of a building that the paper refines: centre in the map frame and width
/// along the building's heading, metres.
struct BuildingState {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
};

/// A wall in the axes of its building, from the centre: x as a share of the width, y in metres.
/// Counter-clockwise around the building.
struct ModelWall {
  enum class Runs { Along, Across, Slanted };  ///< against the building's heading
  Runs runs;
  float from_x, from_y;
  float to_x, to_y;
};

/// The part of a drawn building that a swarm does not change: heading, depth and outline. A polygon
/// is moved and stretched as a whole, by its bounding box.
class BuildingModel {
 public:
  explicit BuildingModel(const Building& building);

  const BuildingState& drawn() const { return drawn_; }
  double heading() const { return heading_; }
  const std::vector<ModelWall>& walls() const { return walls_; }
  /// Of a circle around the centre that holds footprint(state), metres.
  double radius(const BuildingState& state) const {
    return std::hypot(reach_ * state.width, reach_across_);
  }
  Polygon footprint(const BuildingState& state) const;
  /// The box of footprint(state).
  Rectangle box(const BuildingState& state) const;

 private:
  BuildingState drawn_;
  double heading_;
  double depth_;
  std::vector<Vec2> outline_;  ///< corners as the ends of walls()
  std::vector<ModelWall> walls_;
  double reach_ = 0.0;  ///< of the outline along the heading, as a share of the width
  double reach_across_ = 0.0;
};

}  // namespace handmap
