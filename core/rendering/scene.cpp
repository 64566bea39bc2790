#include "core/rendering/scene.h"

#include <algorithm>

#include "core/rendering/noise.h"
#include "core/rendering/reflectance.h"
#include "core/rendering/visibility.h"

namespace handmap {

namespace {

constexpr double kFarBuildings_m = 350.0;
constexpr double kFarThings_m = 120.0;
constexpr double kHaze_m = 900.0;
const Colour kHazeColour(0.72F, 0.77F, 0.83F);

Vec3 sunDirection(const Light& light) {
  const double elevation = toRadians(light.sun_elevation_deg);
  const Vec2 flat = std::cos(elevation) * unitVector(toRadians(light.sun_azimuth_deg));
  return {flat.x(), flat.y(), std::sin(elevation)};
}

/// Clouds pass before the sun.
float sunAt(const Light& light, double time_s, std::uint64_t seed) {
  const auto phase = static_cast<float>(std::remainder(time_s / light.cloud_period_s, 1e5));
  const float clouds =
      0.5F + 0.5F * smoothNoise(phase, 0.5F, static_cast<std::uint32_t>(seed) + 40);
  return static_cast<float>(light.sun) * (1.0F - static_cast<float>(light.cloud_share) *
                                                     std::clamp(1.6F * clouds - 0.3F, 0.0F, 1.0F));
}

/// Fewer and larger pieces far away.
int leavesAt(double distance) {
  if (distance < 15.0) return 3000;
  if (distance < 30.0) return 1200;
  return distance < 65.0 ? 350 : 120;
}

/// The place on a plane that a pixel sees, and how it moves from one pixel to the next.
struct Hit {
  Hit(const InverseDepth& plane, const ViewCamera& camera, double u, double v) {
    const double inverse = plane.at(u, v);
    depth = 1.0 / inverse;
    const Vec3 from_eye = depth * camera.ray(u, v);
    point = camera.eye + from_eye;
    by_column = depth * (camera.right / camera.fx - plane.at_u * from_eye);
    by_row = depth * (camera.down / camera.fy - plane.at_v * from_eye);
  }
  double depth;
  Vec3 point;
  Vec3 by_column;
  Vec3 by_row;
};

Colour hazed(const Colour& colour, double depth) {
  const auto left = static_cast<float>(std::exp(-depth / kHaze_m));
  return left * colour + (1.0F - left) * kHazeColour;
}

void addThing(const Thing& thing, std::uint64_t seed, std::uint32_t number, Model& model) {
  switch (thing.kind) {
    case Thing::Kind::Car:
      return addCar(thing, seed, number, model);
    case Thing::Kind::Hedge:
      return addHedge(thing, seed, number, model);
    case Thing::Kind::Person:
      return addPerson(thing, seed, number, model);
    case Thing::Kind::Sign:
      return addSign(thing, seed, number, model);
    case Thing::Kind::Lamp:
      return addLamp(thing, seed, model);
    case Thing::Kind::Fence:
      return addFence(thing, seed, number, model);
    case Thing::Kind::Rack:
      return addRack(thing, seed, number, model);
  }
}

}  // namespace

Scene::Scene(const World& world, const Light& light, const Vec2& centre, double time_s)
    : to_sun_(sunDirection(light)),
      sun_(sunAt(light, time_s, world.seed)),
      ground_(world.map.route, centre, world.seed),
      sun_map_(centre, to_sun_),
      sky_(to_sun_, sun_, world.seed) {
  addBuildings(world, centre);
  addThings(world, centre);
  addPlants(world, centre);
  sun_map_.add(model_.surfaces);
}

void Scene::addBuildings(const World& world, const Vec2& centre) {
  for (std::size_t i = 0; i < world.map.buildings.size(); ++i) {
    const Polygon footprint = world.map.buildings[i].footprint();
    if (distanceTo(footprint, centre) > kFarBuildings_m) continue;
    addBuilding(world, i, model_);
  }
}

void Scene::addThings(const World& world, const Vec2& centre) {
  for (std::size_t i = 0; i < world.things.size(); ++i) {
    const Thing& thing = world.things[i];
    if ((thing.footprint.centre - centre).norm() > kFarThings_m) continue;
    const auto number = static_cast<std::uint32_t>(i);
    addThing(thing, world.seed, number, model_);
  }
}

void Scene::addPlants(const World& world, const Vec2& centre) {
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    const Obstacle& plant = world.obstacles[i];
    const double away = (plant.centre - centre).norm();
    if (away > kFarThings_m) continue;
    double clear = 10.0;
    for (const Building& building : world.map.buildings) {
      if ((building.box().centre - plant.centre).norm() > 100.0) continue;
      clear = std::min(clear, distanceTo(building.footprint(), plant.centre) - 0.2);
    }
    const auto number = static_cast<std::uint32_t>(i);
    addPlant(plant, clear, leavesAt(away), world.seed, number, model_);
  }
}

Colour Scene::lit(const Colour& reflectance, const Vec3& point, const Vec3& normal) const {
  const auto up = static_cast<float>(normal.z());
  const Colour from_sky = Colour(0.36F, 0.40F, 0.46F) * (0.6F + 0.4F * up);
  const Colour from_ground = Colour(0.10F, 0.095F, 0.08F) * (0.5F - 0.5F * up);
  const float facing = std::max(0.0F, static_cast<float>(normal.dot(to_sun_)));
  const float sun = facing > 0.0F ? sun_ * sun_map_.sunAt(point, normal) : 0.0F;
  return reflectance * (from_sky + from_ground + Colour(1.55F, 1.45F, 1.28F) * (sun * facing));
}

Colour Scene::radiance(std::int32_t seen, const ViewCamera& camera, double u, double v) const {
  if (seen == Visibility::kSky) {
    return sky_.colourAt(camera.ray(u, v), static_cast<float>(1.0 / camera.fx));
  }
  if (seen == Visibility::kGround) return groundRadiance(camera, u, v);
  return surfaceRadiance(model_.surfaces[static_cast<std::size_t>(seen)], camera, u, v);
}

Colour Scene::groundRadiance(const ViewCamera& camera, double u, double v) const {
  const InverseDepth plane(Vec3::Zero(), Vec3::UnitZ(), camera);
  const Hit hit(plane, camera, u, v);
  const auto x = static_cast<float>(hit.point.x());
  const auto y = static_cast<float>(hit.point.y());
  const auto pixel =
      static_cast<float>(std::sqrt(hit.by_column.head<2>().norm() * hit.by_row.head<2>().norm()));
  const Colour colour = ground_.colourAt(x, y, pixel);
  return hazed(lit(colour, hit.point, Vec3::UnitZ()), hit.depth);
}

Colour Scene::surfaceRadiance(const Surface& surface, const ViewCamera& camera, double u,
                              double v) const {
  const InverseDepth plane(surface.corners[0], surface.normal, camera);
  const Hit hit(plane, camera, u, v);
  const Vec3 from_origin = hit.point - surface.origin;
  const auto extent = [&](const Vec3& axis) {
    return static_cast<float>(std::abs(hit.by_column.dot(axis)) + std::abs(hit.by_row.dot(axis)));
  };
  const TexturePoint at{static_cast<float>(from_origin.dot(surface.along)),
                        static_cast<float>(from_origin.dot(surface.up)), extent(surface.along),
                        extent(surface.up)};
  const bool towards_eye = surface.normal.dot(camera.eye - surface.corners[0]) > 0.0;
  const Vec3 normal = towards_eye ? surface.normal : Vec3(-surface.normal);
  const Colour colour = reflectanceAt(surface, model_, at);
  return hazed(lit(colour, hit.point, normal), hit.depth);
}

Label Scene::labelAt(std::int32_t seen, const ViewCamera& camera, double u, double v) const {
  if (seen == Visibility::kSky) return sky_.labelAt(camera.ray(u, v));
  if (seen != Visibility::kGround) return model_.surfaces[static_cast<std::size_t>(seen)].label;
  const Vec3 ray = camera.ray(u, v);
  const Vec3 point = camera.eye - camera.eye.z() / ray.z() * ray;
  return ground_.labelAt(static_cast<float>(point.x()), static_cast<float>(point.y()));
}

}  // namespace handmap
