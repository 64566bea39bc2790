#include <fmt/format.h>

#include "core/base/random.h"
#include "core/simulation/site.h"
#include "core/simulation/wall_frame.h"

namespace handmap {

namespace {

constexpr std::uint32_t kSheds = 44;

// All of them choices: what stands in front gardens.
constexpr int kTries = 20;          // for a place where nothing stands
constexpr double kShedShare = 0.6;  // of the fronts that have one
constexpr double kCarShare = 0.5;   // of the places along a front
constexpr double kFrontCar_m = 5.5;
constexpr double kToFront_m = 2.5;  // farthest from the wall

/// A garage or a shed, somewhere before the front.
Rectangle shedBefore(const WallFrame& front, RandomStream& random) {
  Rectangle shed;
  shed.width = random.uniform(2.2, 6.0);
  shed.depth = random.uniform(2.0, 3.5);
  const double away = random.uniform(Site::kToWall_m + 0.1, kToFront_m);
  const double along = random.uniform(-0.1, 1.1) * front.length;
  shed.centre = front.at(along, away + shed.depth / 2.0);
  shed.heading = normalizedAngle(front.heading() + random.normal(0.0, toRadians(2.0)));
  return shed;
}

Thing carBefore(const WallFrame& front, double along, RandomStream& random) {
  Thing car;
  car.footprint.width = random.uniform(3.7, 4.7);
  car.footprint.depth = random.uniform(1.65, 1.8);
  const double away = random.uniform(Site::kToWall_m + 0.1, kToFront_m);
  car.footprint.centre = front.at(along, away + car.footprint.depth / 2.0);
  car.footprint.heading = normalizedAngle(front.heading() + random.normal(0.0, 0.03) +
                                          (random.uniform() < 0.5 ? 0.0 : kPi));
  car.height = random.uniform(1.4, 1.6);
  return car;
}

void parkCars(const WallFrame& front, Site& site, RandomStream& random) {
  for (double along = kFrontCar_m / 2.0; along < front.length; along += kFrontCar_m) {
    if (random.uniform() > kCarShare) continue;
    for (int i = 0; i < kTries; ++i) {
      const Thing car = carBefore(front, along, random);
      if (!site.isFree(car.footprint)) continue;
      site.put({car});
      break;
    }
  }
}

void putUpShed(const WallFrame& front, Site& site, World& world, RandomStream& random) {
  if (random.uniform() > kShedShare) return;
  for (int i = 0; i < kTries; ++i) {
    const Rectangle shed = shedBefore(front, random);
    if (!site.isFree(shed)) continue;
    site.take(shed);
    Building building;
    building.id = fmt::format("undrawn {}", ++world.undrawn);
    building.shape = shed;
    if (!world.walls.empty()) world.walls.push_back(shed.corners());
    world.map.buildings.push_back(building);
    return;
  }
}

}  // namespace

World withSheds(World world, std::uint64_t seed) {
  Site site(world);
  const std::size_t houses = world.map.buildings.size();
  for (std::size_t i = 0; i < houses; ++i) {
    RandomStream random(seed, static_cast<std::uint32_t>(i), 0, kSheds);
    const WallFrame front = frontOf(world.map.buildings[i].footprint(), site.route());
    putUpShed(front, site, world, random);
    parkCars(front, site, random);
  }
  return world;
}

}  // namespace handmap
