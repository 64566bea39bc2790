#include "core/simulation/surroundings.h"

#include "core/simulation/appearance.h"

namespace handmap {

namespace {

constexpr double kPlantTop_m = 8.0;  // choice: street trees; boulevard's features end at 7 m

/// Law of Beer and Lambert: what stops a ray is spread evenly.
double depthIn(double free_path_m, RandomStream& random) {
  return free_path_m > 0.0 ? -free_path_m * std::log(1.0 - random.uniform()) : 0.0;
}

template <typename Thing, typename Distance>
std::vector<Thing> near(const std::vector<Thing>& things, double reach_m, Distance distance) {
  std::vector<Thing> result;
  for (const Thing& thing : things) {
    if (distance(thing) <= reach_m) result.push_back(thing);
  }
  return result;
}

}  // namespace

Surroundings::Surroundings(const World& world) : plants_(world.obstacles) {
  for (std::size_t i = 0; i < world.map.buildings.size(); ++i) {
    const Polygon corners = world.wallsOf(i);
    const double top_m = appearanceOf(world, i).eaves_m();
    for (std::size_t k = 0; k < corners.size(); ++k) {
      walls_.push_back({{corners[k], corners[(k + 1) % corners.size()]}, top_m});
    }
  }
  for (const Thing& thing : world.things) {
    bodies_.push_back({thing.footprint.corners(), thing.height, thing.free_path_m});
  }
}

Surroundings Surroundings::within(double reach_m, const Vec2& eye) const {
  Surroundings some;
  some.walls_ = near(walls_, reach_m, [&](const Wall& wall) { return distanceTo(wall.at, eye); });
  some.bodies_ =
      near(bodies_, reach_m, [&](const Body& body) { return distanceTo(body.corners, eye); });
  some.plants_ = near(plants_, reach_m, [&](const Obstacle& plant) {
    return (plant.centre - eye).norm() - plant.radius;
  });
  return some;
}

Hit Surroundings::cast(const SensorRay& ray, RandomStream& random) const {
  Hit hit;
  for (const Wall& wall : walls_) {
    const double distance = rayToSegment(ray.origin, ray.direction, wall.at);
    if (distance < hit.distance && ray.heightAt(distance) < wall.top_m) hit.distance = distance;
  }
  const auto meet = [&](const Crossing& crossing, double top_m, double free_path_m, Hit::On on) {
    if (crossing.in >= hit.distance || ray.heightAt(crossing.in) >= top_m) return;
    const double distance = crossing.in + depthIn(free_path_m, random);
    if (distance > crossing.out && free_path_m > 0.0) return;
    if (distance < hit.distance) hit = {distance, on};
  };
  for (const Body& body : bodies_) {
    meet(rayThrough(ray.origin, ray.direction, body.corners), body.top_m, body.free_path_m,
         Hit::On::Thing);
  }
  for (const Obstacle& plant : plants_) {
    meet(rayThroughCircle(ray.origin, ray.direction, plant.centre, plant.radius), kPlantTop_m,
         plant.free_path_m, Hit::On::Plant);
  }
  return hit;
}

}  // namespace handmap
