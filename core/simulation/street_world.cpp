#include <algorithm>

#include <fmt/format.h>

#include "core/base/random.h"
#include "core/simulation/route.h"
#include "core/simulation/trees.h"
#include "core/simulation/world.h"

namespace handmap {

namespace {

constexpr std::uint32_t kStreet = 9;
constexpr double kKerb_m = 4.0;       // from the middle of the road
constexpr double kLongest_m = 400.0;  // of a street before it is cut behind its last house
constexpr double kGap_m = 2.0;

/// The houses of one side, one after the other.
class Side {
 public:
  Side(const Route& route, bool left, RandomStream& random, Map& map)
      : route_(route), left_(left), random_(random), map_(map) {}

  /// Returns where on the route the last house ends.
  double build(int houses) {
    double s = random_.uniform(1.0, 8.0);
    for (int i = 1; i <= houses; ++i) {
      Rectangle box;
      box.width = random_.uniform(8.0, 20.0);
      box.depth = random_.uniform(8.0, 12.0);
      const double front = kKerb_m + random_.uniform(4.0, 8.0);
      const double turn = random_.normal(0.0, toRadians(1.0));
      box = placed(box, front, turn, s);
      while (meetsNeighbour(box)) box = placed(box, front, turn, s += 0.5);  // inside of a bend
      Building building;
      building.id = fmt::format("{}{}", left_ ? 'L' : 'R', i);
      building.shape = box;
      map_.buildings.push_back(building);
      s += box.width;
      end_ = s;
      s += random_.uniform(kGap_m + 0.2, 8.0);
    }
    return end_;
  }

 private:
  Rectangle placed(Rectangle box, double front, double turn, double s) const {
    const Pose2 beside = route_.poseAt(s + box.width / 2.0);
    const double side = left_ ? 1.0 : -1.0;
    box.centre = beside.toOuter({0.0, side * (front + box.depth / 2.0)});
    box.heading = normalizedAngle(beside.heading + turn);
    return box;
  }

  bool meetsNeighbour(const Rectangle& box) const {
    Rectangle grown = box;
    grown.width += 2.0 * kGap_m;
    return std::any_of(map_.buildings.begin(), map_.buildings.end(), [&](const Building& other) {
      return overlap(grown.corners(), other.footprint());
    });
  }

  const Route& route_;
  bool left_;
  RandomStream& random_;
  Map& map_;
  double end_ = 0.0;
};

}  // namespace

World streetWorld(std::uint64_t seed) {
  RandomStream random(seed, 0, 0, kStreet);
  Map map;
  map.name = fmt::format("Street, {}", seed);
  map.start = Pose2{};
  const double bend_at = random.uniform(50.0, 80.0);
  const double bend = random.uniform() < 0.4 ? 0.0 : toRadians(random.uniform(-8.0, 8.0));
  const Vec2 corner(bend_at, 0.0);
  const Route street({Vec2::Zero(), corner, corner + (kLongest_m - bend_at) * unitVector(bend)});
  const int houses = 12 + random.index(7);
  const double left_end = Side(street, true, random, map).build(houses / 2);
  const double right_end = Side(street, false, random, map).build(houses - houses / 2);
  map.route = {Vec2::Zero(), corner,
               corner + (std::max(left_end, right_end) - bend_at) * unitVector(bend)};
  std::vector<Obstacle> trees = treesAlong(Route(map.route), map, random);
  return furnished({std::move(map), std::move(trees), {}, seed}, seed);
}

}  // namespace handmap
