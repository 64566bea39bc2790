// Small worlds and cameras to look at them with.
#pragma once

#include "core/rendering/renderer.h"

namespace handmap::test {

inline Building box(const char* id, const Rectangle& shape) {
  Building building;
  building.id = id;
  building.shape = shape;
  return building;
}

/// The robot at the origin looks along +x. Buildings have vertical walls and flat roofs where they
/// are polygons.
inline World worldOf(std::vector<Building> buildings) {
  World world;
  world.map.buildings = std::move(buildings);
  world.map.start = Pose2{};
  world.map.route = {{0, 0}, {5, 0}};
  world.seed = 3;
  return world;
}

inline RenderOptions smallCamera() {
  RenderOptions options;
  options.width = 160;
  options.height = 120;
  return options;
}

}  // namespace handmap::test
