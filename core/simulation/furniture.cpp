#include <algorithm>

#include "core/base/random.h"
#include "core/simulation/site.h"

namespace handmap {

namespace {

constexpr std::uint32_t kCars = 7;
constexpr std::uint32_t kHedges = 8;
constexpr std::uint32_t kLamps = 11;
constexpr std::uint32_t kSigns = 12;
constexpr std::uint32_t kPeople = 13;

constexpr double kCarSpacing_m = 6.5;
constexpr double kCarOffset_m = 3.0;  // of its middle from the route: a wheel at the kerb
constexpr double kPost_m = 4.35;      // of a sign or a lamp from the route: at the kerb
constexpr double kLampSpacing_m = 26.0;
constexpr double kSignSpacing_m = 28.0;
constexpr double kPeopleSpacing_m = 8.0;
constexpr double kSquare_m = 14.0;  // people stand so far from the route, where no house is

class Furniture {
 public:
  Furniture(World& world, std::uint64_t seed)
      : world_(world), site_(world), route_(site_.route()), seed_(seed) {}

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
      const double offset =
          Site::kPavement_m + share * std::max(0.0, wall - 1.5 - Site::kPavement_m);
      hedge.footprint.centre = beside.toOuter({0.0, std::copysign(offset, place.offset)});
      hedge.footprint.heading = beside.heading;
      put(hedge);
    }
  }

  /// One side after the other; all of a kind.
  void putUpLamps() {
    RandomStream random(seed_, 0, 0, kLamps);
    const double height =
        random.uniform() < 0.6 ? random.uniform(5.5, 8.0) : random.uniform(3.4, 4.2);
    double side = random.uniform() < 0.5 ? 1.0 : -1.0;
    for (double s = random.uniform(2.0, kLampSpacing_m); s < route_.length(); s += kLampSpacing_m) {
      const Pose2 beside = route_.poseAt(s + random.uniform(-2.0, 2.0));
      const double towards_road = beside.heading - side * kPi / 2.0;
      put({Thing::Kind::Lamp,
           {beside.toOuter({0.0, side * kPost_m}), 0.16, 0.16, normalizedAngle(towards_road)},
           height});
      side = -side;
    }
  }

  /// Those on the right look at who comes along the route, those on the left the other way.
  void putUpSigns() {
    RandomStream random(seed_, 0, 0, kSigns);
    for (const double side : {1.0, -1.0}) {
      for (double s = 5.0; s < route_.length(); s += kSignSpacing_m) {
        const Pose2 beside = route_.poseAt(s + random.uniform(0.0, 0.8 * kSignSpacing_m));
        const double turn = random.normal(0.0, 0.1) + (side > 0.0 ? 0.0 : kPi);
        const double height = random.uniform(2.4, 3.0);
        if (random.uniform() > 0.6) continue;
        put({Thing::Kind::Sign,
             {beside.toOuter({0.0, side * kPost_m}), 0.07, 0.07,
              normalizedAngle(beside.heading + turn)},
             height});
      }
    }
  }

  /// Alone or in twos and threes.
  void placePeople() {
    RandomStream random(seed_, 0, 0, kPeople);
    for (const double side : {1.0, -1.0}) {
      for (double s = 2.0; s < route_.length(); s += kPeopleSpacing_m) {
        const Pose2 beside = route_.poseAt(s + random.uniform(0.0, kPeopleSpacing_m));
        const bool on_square = random.uniform() < 0.3;
        const double offset =
            on_square ? random.uniform(Site::kPavement_m, kSquare_m) : random.uniform(4.4, 5.2);
        const double share = random.uniform();
        const int together = share < 0.65 ? 0 : share < 0.85 ? 1 : share < 0.95 ? 2 : 3;
        Vec2 place = beside.toOuter({0.0, side * offset});
        for (int i = 0; i < together; ++i) {
          const double heading = random.uniform(-kPi, kPi);
          put({Thing::Kind::Person, {place, 0.3, 0.5, heading}, random.uniform(1.5, 1.95)});
          place += random.uniform(1.3, 1.8) * unitVector(beside.heading + random.normal(0.0, 0.4));
        }
      }
    }
  }

 private:
  void put(const Thing& thing) { site_.put({thing}); }

  World& world_;
  Site site_;
  const Route& route_;
  std::uint64_t seed_;
};

}  // namespace

World furnished(World world, std::uint64_t seed) {
  Furniture(world, seed).parkCars();
  return withoutCars(std::move(world), seed);
}

World withoutCars(World world, std::uint64_t seed) {
  Furniture furniture(world, seed);
  furniture.plantHedges();
  furniture.putUpLamps();
  furniture.putUpSigns();
  furniture.placePeople();
  return world;
}

}  // namespace handmap
