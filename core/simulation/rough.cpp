#include <algorithm>

#include "core/base/random.h"
#include "core/simulation/appearance.h"
#include "core/simulation/site.h"
#include "core/simulation/wall_frame.h"

namespace handmap {

namespace {

constexpr std::uint32_t kWalls = 15;
constexpr std::uint32_t kFences = 16;
constexpr std::uint32_t kRacks = 17;
constexpr std::uint32_t kPlants = 18;

constexpr double kLongWall_m = 6.0;
constexpr double kCornerLeft_m = 0.8;  // of a wall before its first recess
constexpr double kPanel_m = 2.2;       // of a fence
constexpr double kFence_m = 0.06;      // its thickness
constexpr double kClear_m = 3.0;       // half the width that bays leave to the robot
constexpr double kPiece_m = 1.3;       // of a ragged hedge

/// The wall from its first corner to before its last one. A recess goes in, a bay comes out.
Polygon brokenWall(const WallFrame& wall, RandomStream& random) {
  Polygon corners{wall.corner};
  double s = kCornerLeft_m + random.uniform(0.0, 5.0);
  while (true) {
    const double width = random.uniform(1.2, 4.0);
    const double depth = random.uniform() < 0.7 ? -random.uniform(0.2, 1.3)  // a recess
                                                : random.uniform(0.2, 0.9);
    const double next = s + width + random.uniform(2.0, 20.0);
    if (s + width > wall.length - kCornerLeft_m) return corners;
    for (const Vec2& corner :
         {wall.at(s, 0.0), wall.at(s, depth), wall.at(s + width, depth), wall.at(s + width, 0.0)}) {
      corners.push_back(corner);
    }
    s = next;
  }
}

class Roughness {
 public:
  Roughness(World& world, std::uint64_t seed)
      : world_(world), route_(*routeOf(world.map)), seed_(seed) {}

  /// A wall that may carry a gable stays whole, and so does one whose bays would meet something.
  void breakWalls() {
    for (std::size_t i = 0; i < world_.map.buildings.size(); ++i) {
      world_.walls.push_back(world_.map.buildings[i].footprint());
    }
    for (std::size_t i = 0; i < world_.walls.size(); ++i) {
      RandomStream random(seed_, static_cast<std::uint32_t>(i), 0, kWalls);
      const double shortest = std::max(kLongWall_m, gableOf(i));
      const Polygon footprint = world_.walls[i];
      for (std::size_t k = footprint.size(); k-- > 0;) {
        const WallFrame wall(footprint[k], footprint[(k + 1) % footprint.size()]);
        if (wall.length < shortest) continue;
        const Polygon part = brokenWall(wall, random);
        Polygon changed = world_.walls[i];
        changed.insert(changed.begin() + static_cast<std::ptrdiff_t>(k) + 1, part.begin() + 1,
                       part.end());
        if (isSimple(changed) && isFree(changed, i)) world_.walls[i] = changed;
      }
    }
  }

  void tearPlants() {
    RandomStream random(seed_, 0, 0, kPlants);
    for (Obstacle& plant : world_.obstacles) {
      if (plant.radius >= Obstacle::kBush_m) plant.free_path_m = random.uniform(0.1, 0.5);
    }
    std::vector<Thing> things;
    for (const Thing& thing : world_.things) {
      const bool hedge = thing.kind == Thing::Kind::Hedge;
      const std::vector<Thing> pieces = hedge ? torn(thing, random) : std::vector<Thing>{thing};
      things.insert(things.end(), pieces.begin(), pieces.end());
    }
    world_.things = things;
  }

  /// Some before a building, along the route; some beside it, away from the route.
  void putUpFences() {
    RandomStream random(seed_, 0, 0, kFences);
    Site site(world_);
    for (const Building& building : world_.map.buildings) {
      const Rectangle box = building.box();
      const Route::Projection place = route_.project(box.centre);
      const double side = std::copysign(1.0, place.offset);
      const double wall = route_.distanceTo(building.footprint());
      const double length = random.uniform(6.0, 1.2 * box.width + 6.0);
      const double offset = Site::kPavement_m + random.uniform(0.0, 0.8) *
                                                    std::max(0.0, wall - 1.5 - Site::kPavement_m);
      if (random.uniform() < 0.5) {
        site.put(fence({place.s - length / 2.0, side * offset}, length, true, random));
      }
      const double end = place.s + box.width / 2.0 + random.uniform(0.5, 3.0);
      const double depth = random.uniform(6.0, 6.0 + box.depth);
      if (random.uniform() < 0.6) site.put(fence({end, side * wall}, depth, false, random));
    }
  }

  /// At the wall that looks at the route.
  void putUpRacks() {
    RandomStream random(seed_, 0, 0, kRacks);
    Site site(world_);
    for (const Building& building : world_.map.buildings) {
      const WallFrame wall = frontOf(building.footprint(), route_);
      Thing rack;
      rack.kind = Thing::Kind::Rack;
      rack.height = random.uniform(1.05, 1.15);
      rack.free_path_m = random.uniform(1.0, 3.0);
      rack.footprint.width = random.uniform(2.0, 7.0);
      rack.footprint.depth = 1.8;
      rack.footprint.heading = wall.heading();
      const double from_wall = random.uniform(0.05, 1.0) + 0.9 + Site::kToWall_m;
      const double share = random.uniform(0.2, 0.8);
      if (random.uniform() > 0.6 || rack.footprint.width > wall.length) continue;
      rack.footprint.centre = wall.at(share * wall.length, from_wall);
      site.put({rack});
    }
  }

 private:
  /// Pieces of a hedge, of which some are missing.
  static std::vector<Thing> torn(const Thing& hedge, RandomStream& random) {
    const Rectangle& whole = hedge.footprint;
    const Pose2 frame{whole.centre.x(), whole.centre.y(), whole.heading};
    const int count = std::max(1, static_cast<int>(whole.width / kPiece_m));
    Thing piece = hedge;
    piece.free_path_m = random.uniform(0.1, 0.4);
    piece.footprint.width = whole.width / count;
    std::vector<Thing> pieces;
    for (int i = 0; i < count; ++i) {
      piece.height = std::max(0.6, hedge.height + random.normal(0.0, 0.2));
      piece.footprint.depth = whole.depth * random.uniform(0.5, 1.0);
      const double aside = (whole.depth - piece.footprint.depth) / 2.0;
      piece.footprint.centre = frame.toOuter(
          {(i + 0.5) * piece.footprint.width - whole.width / 2.0, random.uniform(-aside, aside)});
      if (random.uniform() < 0.92) pieces.push_back(piece);
    }
    return pieces;
  }

  /// Panels from a place beside the route (s, offset), along the route or away from it.
  std::vector<Thing> fence(const Vec2& from, double length, bool along,
                           RandomStream& random) const {
    Thing panel;
    panel.kind = Thing::Kind::Fence;
    panel.height = random.uniform(0.9, 1.9);
    panel.free_path_m = random.uniform(0.03, 0.2);
    std::vector<Thing> panels;
    for (double at = kPanel_m / 2.0; at < length; at += kPanel_m) {
      const Vec2 place = along ? Vec2(from.x() + at, from.y())
                               : Vec2(from.x(), from.y() + std::copysign(at, from.y()));
      if (place.x() < 0.0 || place.x() > route_.length()) continue;
      const Pose2 beside = route_.poseAt(place.x());
      panel.footprint = {beside.toOuter({0.0, place.y()}), kPanel_m, kFence_m,
                         normalizedAngle(beside.heading + (along ? 0.0 : kPi / 2.0))};
      panels.push_back(panel);
    }
    return panels;
  }

  /// Below this length a wall of the building may carry a gable.
  double gableOf(std::size_t building) const {
    if (appearanceOf(world_, building).roof != Appearance::Roof::Gable) return 0.0;
    const Rectangle box = world_.map.buildings[building].box();
    return std::min(box.width, box.depth) + 1e-6;
  }

  bool isFree(const Polygon& walls, std::size_t building) const {
    for (std::size_t i = 0; i < world_.walls.size(); ++i) {
      if (i != building && overlap(walls, world_.walls[i])) return false;
    }
    return route_.distanceTo(walls) > kClear_m &&
           std::none_of(
               world_.things.begin(), world_.things.end(),
               [&](const Thing& thing) { return overlap(walls, thing.footprint.corners()); }) &&
           std::none_of(world_.obstacles.begin(), world_.obstacles.end(),
                        [&](const Obstacle& obstacle) {
                          return distanceTo(walls, obstacle.centre) < obstacle.radius;
                        });
  }

  World& world_;
  Route route_;
  std::uint64_t seed_;
};

}  // namespace

World rough(World world, std::uint64_t seed) {
  if (world.things.empty()) world = withoutCars(std::move(world), seed);
  Roughness roughness(world, seed);
  roughness.breakWalls();
  roughness.tearPlants();
  roughness.putUpFences();
  roughness.putUpRacks();
  return world;
}

}  // namespace handmap
