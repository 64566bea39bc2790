// What a swarm particle stands for: a building moved to x, y and stretched to a width.
#pragma once

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

/// The part of a drawn building that a swarm does not change: heading, depth and outline. A polygon
/// is moved and stretched as a whole, by its bounding box.
class BuildingModel {
 public:
  explicit BuildingModel(const Building& building);

  const BuildingState& drawn() const { return drawn_; }
  double heading() const { return heading_; }
  /// Corners in building terms: x as a share of the width, y in metres across, from the centre.
  const std::vector<Vec2>& outline() const { return outline_; }
  Polygon footprint(const BuildingState& state) const;
  /// The box of footprint(state).
  Rectangle box(const BuildingState& state) const;

 private:
  BuildingState drawn_;
  double heading_;
  double depth_;
  std::vector<Vec2> outline_;
};

}  // namespace handmap
