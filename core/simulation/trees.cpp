#include "core/simulation/trees.h"

#include <algorithm>

namespace handmap {

namespace {

constexpr double kSpacing = 10.0;  // one try for a tree in so many metres of the route
constexpr double kWay = 2.5;       // half the width that stays free for the robot

}  // namespace

std::vector<Obstacle> treesAlong(const Route& route, const Map& map, RandomStream& random) {
  std::vector<Polygon> footprints;
  for (const Building& building : map.buildings) footprints.push_back(building.footprint());
  std::vector<Obstacle> trees;
  for (double s = 0.0; s < route.length(); s += kSpacing) {
    const Pose2 beside = route.poseAt(s + random.uniform(0.0, kSpacing));
    const double radius = random.uniform(0.3, 1.2);
    const double side = random.uniform() < 0.5 ? -1.0 : 1.0;
    const Vec2 centre = beside.toOuter({0.0, side * random.uniform(4.0, 14.0)});
    const bool free = std::none_of(
        footprints.begin(), footprints.end(),
        [&](const Polygon& footprint) { return distanceTo(footprint, centre) < radius + 0.5; });
    if (free && std::abs(route.project(centre).offset) > radius + kWay) {
      trees.push_back({centre, radius});
    }
  }
  return trees;
}

}  // namespace handmap
