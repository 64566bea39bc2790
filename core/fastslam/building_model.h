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
  const Vec2& ahead() const { return ahead_; }  ///< unitVector(heading())
  const std::vector<ModelWall>& walls() const { return walls_; }
  Polygon footprint(const BuildingState& state) const;
  /// The box of footprint(state).
  Rectangle box(const BuildingState& state) const;
  /// Whether box(state) holds a point; footprint(state) holds no other.
  bool mayHold(const BuildingState& state, const Vec2& point) const {
    const Vec2 offset(point.x() - state.x, point.y() - state.y);
    return std::abs(ahead_.dot(offset)) <= state.width / 2.0 &&
           std::abs(cross(ahead_, offset)) <= depth_ / 2.0;
  }
  /// Whether two boxes of one heading have nothing in common; false where that is not easily told.
  bool isApart(const BuildingState& state, const BuildingModel& other,
               const BuildingState& other_state) const {
    if (other.heading_ != heading_) return false;
    const Vec2 offset(other_state.x - state.x, other_state.y - state.y);
    return std::abs(ahead_.dot(offset)) >= (state.width + other_state.width) / 2.0 ||
           std::abs(cross(ahead_, offset)) >= (depth_ + other.depth_) / 2.0;
  }

 private:
  BuildingState drawn_;
  double heading_;
  Vec2 ahead_;
  double depth_;
  std::vector<Vec2> outline_;  ///< corners as the ends of walls()
  std::vector<ModelWall> walls_;
};

}  // namespace handmap
