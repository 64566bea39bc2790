#include "core/simulation/site.h"

#include <algorithm>

namespace handmap {

namespace {

constexpr double kWay_m = 1.8;  // half the width that stays free for the robot

}  // namespace

Site::Site(World& world) : world_(world), route_(*routeOf(world.map)) {
  for (std::size_t i = 0; i < world.map.buildings.size(); ++i) {
    footprints_.push_back(world.wallsOf(i));
  }
  for (const Thing& thing : world.things) footprints_.push_back(thing.footprint.corners());
}

void Site::put(const std::vector<Thing>& group) {
  std::vector<Thing> free;
  std::copy_if(group.begin(), group.end(), std::back_inserter(free),
               [this](const Thing& thing) { return isFree(thing.footprint); });
  for (const Thing& thing : free) {
    footprints_.push_back(thing.footprint.corners());
    world_.things.push_back(thing);
  }
}

bool Site::isFree(const Rectangle& footprint) const {
  const Polygon own = footprint.corners();
  Rectangle grown = footprint;
  grown.width += 2.0 * kToWall_m;
  grown.depth += 2.0 * kToWall_m;
  const Polygon around = grown.corners();
  const auto meets = [&](const Polygon& other) { return overlap(around, other); };
  const auto near = [&](const Obstacle& obstacle) {
    return distanceTo(own, obstacle.centre) < obstacle.radius + kToWall_m / 2.0;
  };
  return route_.distanceTo(own) >= kWay_m &&
         std::none_of(footprints_.begin(), footprints_.end(), meets) &&
         std::none_of(world_.obstacles.begin(), world_.obstacles.end(), near);
}

}  // namespace handmap
