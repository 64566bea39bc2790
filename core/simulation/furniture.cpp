#include <algorithm>

#include "core/base/random.h"
#include "core/simulation/route.h"
#include "core/simulation/world.h"

namespace handmap {

namespace {

constexpr std::uint32_t kCars = 7;
constexpr std::uint32_t kHedges = 8;

constexpr double kCarSpacing_m = 6.5;
constexpr double kCarOffset_m = 3.0;  // of its middle from the route: a wheel at the kerb
constexpr double kWay_m = 1.8;        // half the width that stays free for the robot
constexpr double kToWall_m = 0.4;
constexpr double kPavement_m = 5.4;  // a hedge stands behind it

class Furniture {
 public:
  Furniture(World& world, std::uint64_t seed)
      : world_(world), route_(*routeOf(world.map)), seed_(seed) {
    for (const Building& building : world.map.buildings) {
      footprints_.push_back(building.footprint());
    }
  }

  void parkCars() {
    RandomStream random(seed_, 0, 0, kCars);
    for (const double side : {1.0, -1.0}) {
      double free_share = random.uniform(0.3, 0.7);
      for (double s = 4.0; s < route_.length(); s += kCarSpacing_m) {
        const double place = s + random.uniform(-0.6, 0.6);
        const Pose2 beside = route_.poseAt(place);
        const bool turned = random.uniform() < 0.15;
        Thing car;
        car.footprint.centre =
            beside.toOuter({0.0, side * (kCarOffset_m + random.uniform(-0.1, 0.15))});
        car.footprint.width = random.uniform(3.7, 4.7);
        car.footprint.depth = random.uniform(1.65, 1.8);
        car.footprint.heading = normalizedAngle(beside.heading + random.normal(0.0, 0.02) +
                                                (turned == (side > 0.0) ? 0.0 : kPi));
        car.height = random.uniform() < 0.12 ? random.uniform(1.75, 2.0) : random.uniform(1.4, 1.6);
        if (random.uniform() < 0.08) free_share = random.uniform(0.2, 0.8);
        if (random.uniform() > free_share) put(car);
      }
    }
  }

  void plantHedges() {
    RandomStream random(seed_, 0, 0, kHedges);
    for (const Building& building : world_.map.buildings) {
      const Rectangle box = building.box();
      const Route::Projection place = route_.project(box.centre);
      const double wall = route_.distanceTo(building.footprint());
      Thing hedge;
      hedge.kind = Thing::Kind::Hedge;
      hedge.footprint.width = random.uniform(3.0, std::max(4.0, 0.8 * box.width));
      hedge.footprint.depth = random.uniform(0.6, 1.0);
      hedge.height = random.uniform(0.8, 1.8);
      const double along = random.uniform(-0.3, 0.3) * box.width;
      const double share = random.uniform(0.0, 0.6);
      if (random.uniform() > 0.55) continue;
      const Pose2 beside = route_.poseAt(std::clamp(place.s + along, 0.0, route_.length()));
      const double offset = kPavement_m + share * std::max(0.0, wall - 1.5 - kPavement_m);
      hedge.footprint.centre = beside.toOuter({0.0, std::copysign(offset, place.offset)});
      hedge.footprint.heading = beside.heading;
      put(hedge);
    }
  }

 private:
  /// Where nothing stands yet and the robot does not pass.
  void put(const Thing& thing) {
    const Polygon own = thing.footprint.corners();
    Rectangle grown = thing.footprint;
    grown.width += 2.0 * kToWall_m;
    grown.depth += 2.0 * kToWall_m;
    const Polygon around = grown.corners();
    const auto meets = [&](const Polygon& other) { return overlap(around, other); };
    const auto near = [&](const Obstacle& obstacle) {
      return distanceTo(own, obstacle.centre) < obstacle.radius + kToWall_m / 2.0;
    };
    if (route_.distanceTo(own) < kWay_m) return;
    if (std::any_of(footprints_.begin(), footprints_.end(), meets)) return;
    if (std::any_of(world_.obstacles.begin(), world_.obstacles.end(), near)) return;
    footprints_.push_back(own);
    world_.things.push_back(thing);
  }

  World& world_;
  Route route_;
  std::uint64_t seed_;
  std::vector<Polygon> footprints_;  ///< of buildings and things
};

}  // namespace

World furnished(World world, std::uint64_t seed) {
  Furniture furniture(world, seed);
  furniture.parkCars();
  furniture.plantHedges();
  return world;
}

}  // namespace handmap
