#include "core/simulation/world.h"

#include <algorithm>
#include <array>
#include <variant>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/simulation/trees.h"

namespace handmap {

namespace {

// Purposes of random streams: one world does not share its numbers with another.
constexpr std::uint32_t kTwoRows = 1;
constexpr std::uint32_t kCampus = 2;
constexpr std::uint32_t kFromMap = 3;
constexpr std::uint32_t kLoop = 7;
constexpr std::uint32_t kQuarter = 19;
constexpr std::uint32_t kTerraces = 43;

constexpr double kRobotRadius = 0.3;
constexpr double kMaxLength = 20e3;  // of a route from a file

World worldOf(Map map, std::uint64_t seed, RandomStream& random) {
  const std::optional<Route> route = routeOf(map);
  std::vector<Obstacle> trees = treesAlong(*route, map, random);
  return {std::move(map), std::move(trees), {}, seed};
}

Polygon grown(const Rectangle& box, double margin) {
  return Rectangle{box.centre, box.width + 2.0 * margin, box.depth + 2.0 * margin, box.heading}
      .corners();
}

/// The rectangle without its far right or far left quarter, as shares of its sides.
Polygon lShape(const Rectangle& box, double width_share, double depth_share, bool left) {
  const Pose2 frame{box.centre.x(), box.centre.y(), box.heading};
  const double x = box.width / 2.0;
  const double y = box.depth / 2.0;
  const double cut_x = x - width_share * box.width;
  const double cut_y = y - depth_share * box.depth;
  Polygon shape{{-x, -y}, {x, -y}, {x, cut_y}, {cut_x, cut_y}, {cut_x, y}, {-x, y}};
  if (left) {
    for (Vec2& corner : shape) corner.x() = -corner.x();
    std::reverse(shape.begin(), shape.end());
  }
  for (Vec2& corner : shape) corner = frame.toOuter(corner);
  return shape;
}

/// The rectangle without its middle, open to the far side: a courtyard. `wing` in metres.
Polygon uShape(const Rectangle& box, double wing) {
  const Pose2 frame{box.centre.x(), box.centre.y(), box.heading};
  const double x = box.width / 2.0;
  const double y = box.depth / 2.0;
  Polygon shape{
      {-x, -y},      {x, -y}, {x, y}, {x - wing, y}, {x - wing, wing - y}, {wing - x, wing - y},
      {wing - x, y}, {-x, y}};
  for (Vec2& corner : shape) corner = frame.toOuter(corner);
  return shape;
}

/// Of a building that looks at the way: a box, or one of its kinds with less in it.
std::variant<Rectangle, Polygon> anyShape(const Rectangle& box, RandomStream& random) {
  const double kind = random.uniform();
  const double width_share = random.uniform(0.35, 0.65);
  const double depth_share = random.uniform(0.35, 0.65);
  if (kind < 0.25) return lShape(box, width_share, depth_share, random.uniform() < 0.5);
  if (kind < 0.4) return uShape(box, 0.3 * std::min(box.width, box.depth));
  return box;
}

/// Legs that turn by turns to the left and to the right, so that the way never crosses itself.
std::vector<Vec2> windingRoute(RandomStream& random) {
  std::vector<Vec2> points{Vec2::Zero()};
  for (int leg = 0; leg < 4; ++leg) {
    const double heading = leg % 2 == 0 ? 0.0 : toRadians(random.uniform(50.0, 100.0));
    points.push_back(points.back() + random.uniform(55.0, 85.0) * unitVector(heading));
  }
  return points;
}

void checkClear(const Route& route, const Building& building) {
  const Polygon footprint = building.footprint();
  if (route.distanceTo(footprint) > kRobotRadius + Route::kCut) return;
  for (double s = 0.0; s <= route.length(); s += kRobotRadius) {
    if (distanceTo(footprint, route.poseAt(s).position()) > kRobotRadius) continue;
    throwBadInput(phrase("route"), "",
                  phrase("building {} in the way after {:.0f} m", building.id, s),
                  phrase("a way around the buildings"));
  }
}

/// Around blocks of buildings, with the second way begun; fronts `nearest` … `farthest` metres
/// away.
Map blocks(double nearest, double farthest, RandomStream& random) {
  const double inset = farthest + 31.0;  // of a corner inside the loop: no depths meet
  Map map;
  map.start = Pose2{};
  const double length = random.uniform(280.0, 320.0);
  const double width = random.uniform(180.0, 220.0);
  const std::array<Vec2, 5> corners{Vec2(0.0, 0.0), Vec2(length, 0.0), Vec2(length, width),
                                    Vec2(0.0, width), Vec2(0.0, 0.0)};
  map.route.assign(corners.begin(), corners.end());
  map.route.emplace_back(length / 3.0, 0.0);
  for (std::size_t leg = 0; leg + 1 < corners.size(); ++leg) {
    const Vec2 offset = corners[leg + 1] - corners[leg];
    const Pose2 frame{corners[leg].x(), corners[leg].y(), std::atan2(offset.y(), offset.x())};
    for (const double side : {1.0, -1.0}) {  // the left is inside
      const double end = offset.norm() - (side > 0.0 ? inset : 0.0);
      double at = side > 0.0 ? inset : 0.0;
      while (true) {
        Rectangle box;
        box.width = random.uniform(18.0, 45.0);
        box.depth = random.uniform(12.0, 24.0);
        if (at + box.width > end) break;
        const double away = random.uniform(nearest, farthest) + box.depth / 2.0;
        box.centre = frame.toOuter({at + box.width / 2.0, side * away});
        box.heading = normalizedAngle(frame.heading + (side > 0.0 ? 0.0 : kPi) +
                                      random.normal(0.0, toRadians(2.0)));
        at += box.width + random.uniform(6.0, 16.0);
        Building building;
        building.id = fmt::format("B{}", map.buildings.size() + 1);
        building.shape = anyShape(box, random);
        map.buildings.push_back(building);
      }
    }
  }
  return map;
}

}  // namespace

Map World::drawable() const {
  Map drawn = map;
  drawn.buildings.resize(drawn.buildings.size() - undrawn);
  return drawn;
}

World twoRowWorld(std::uint64_t seed) {
  RandomStream random(seed, 0, 0, kTwoRows);
  Map map;
  map.name = fmt::format("Two rows of buildings, {}", seed);
  map.start = Pose2{};
  double end = 0.0;
  for (const bool north : {true, false}) {
    double x = random.uniform(0.0, 12.0);
    for (int i = 1; i <= 3; ++i) {
      Rectangle box;
      box.width = random.uniform(45.0, 65.0);
      box.depth = random.uniform(12.0, 20.0);
      const double y = random.uniform(8.0, 14.0) + box.depth / 2.0;
      box.centre = {x + box.width / 2.0, north ? y : -y};
      end = std::max(end, x + box.width);
      x += box.width + random.uniform(15.0, 30.0);
      Building building;
      building.id = fmt::format("{}{}", north ? 'N' : 'S', i);
      building.shape = box;
      map.buildings.push_back(building);
    }
  }
  map.route = {Vec2::Zero(), {end, 0.0}};
  return worldOf(std::move(map), seed, random);
}

World campusWorld(std::uint64_t seed) {
  constexpr double kSpacing = 12.0;
  constexpr double kRouteMargin = 6.0;
  constexpr double kBuildingMargin = 4.0;
  RandomStream random(seed, 0, 0, kCampus);
  Map map;
  map.name = fmt::format("Campus, {}", seed);
  map.start = Pose2{};
  map.route = windingRoute(random);
  const Route route(map.route);
  std::vector<Polygon> taken;
  for (double s = 0.0; s < route.length(); s += kSpacing) {
    for (const double side : {1.0, -1.0}) {
      const Pose2 beside = route.poseAt(s);
      Rectangle box;
      box.width = random.uniform(15.0, 40.0);
      box.depth = random.uniform(10.0, 20.0);
      box.centre = beside.toOuter({0.0, side * (random.uniform(8.0, 16.0) + box.depth / 2.0)});
      box.heading = normalizedAngle(beside.heading + random.uniform(-kPi / 5.0, kPi / 5.0));
      const bool l_shaped = random.uniform() < 0.3;
      const Polygon ground = grown(box, kBuildingMargin);
      const bool free = route.distanceTo(box.corners()) > kRouteMargin &&
                        std::none_of(taken.begin(), taken.end(),
                                     [&](const Polygon& other) { return overlap(ground, other); });
      if (!free) continue;
      taken.push_back(box.corners());
      Building building;
      building.id = fmt::format("B{}", taken.size());
      building.shape = box;
      if (l_shaped) {
        const bool left = random.uniform() < 0.5;
        const double depth = random.uniform(0.35, 0.65);
        const double width = random.uniform(0.35, 0.65);
        building.shape = lShape(box, width, depth, left);
      }
      map.buildings.push_back(building);
    }
  }
  return worldOf(std::move(map), seed, random);
}

World loopWorld(std::uint64_t seed) {
  RandomStream random(seed, 0, 0, kLoop);
  Map map = blocks(8.0, 14.0, random);
  map.name = fmt::format("Around a campus, {}", seed);
  return worldOf(std::move(map), seed, random);
}

World quarterWorld(std::uint64_t seed) {
  RandomStream random(seed, 0, 0, kQuarter);
  Map map = blocks(5.0, 30.0, random);
  map.name = fmt::format("Quarter, {}", seed);
  return rough(worldOf(std::move(map), seed, random), seed);
}

World terraceWorld(std::uint64_t seed) {
  constexpr double kFront_m = 8.0;   // from the middle of the street, as in laser-sim
  constexpr double kAlley_m = 30.0;  // 12 m behind the houses: the street stays the nearest way
  constexpr double kAhead_m = 10.0;  // of the ends of the rows
  RandomStream random(seed, 0, 0, kTerraces);
  Map map;
  map.name = fmt::format("Terraces, {}", seed);
  map.start = Pose2{-kAhead_m, 0.0, 0.0};
  const bool north_is_flush = random.uniform() < 0.5;
  double end = 0.0;
  for (const bool north : {true, false}) {
    const bool flush = north == north_is_flush;
    double x = 0.0;
    for (int i = 1; i <= 6; ++i) {
      Rectangle box;
      box.width = random.uniform(7.0, 12.0);
      box.depth = flush ? 10.0 : random.uniform(9.0, 11.0);
      const double y = kFront_m + (flush ? 0.0 : random.uniform(0.0, 1.0)) + box.depth / 2.0;
      box.centre = {x + box.width / 2.0, north ? y : -y};
      x += box.width;
      Building building;
      building.id = fmt::format("{}{}", north ? 'N' : 'S', i);
      building.shape = box;
      map.buildings.push_back(building);
    }
    end = std::max(end, x + kAhead_m);
  }
  for (const double alley : {kAlley_m, -kAlley_m}) {
    for (const Vec2& corner :
         {Vec2(-kAhead_m, 0.0), Vec2(end, 0.0), Vec2(end, alley), Vec2(-kAhead_m, alley)}) {
      map.route.push_back(corner);
    }
  }
  map.route.push_back(map.route.front());
  return worldOf(std::move(map), seed, random);
}

World worldFromMap(const Map& map, std::uint64_t seed) {
  const std::optional<Route> route = routeOf(map);
  if (!route) {
    throw Error(ErrorCode::BadInput,
                phrase("route: found no way to drive, expected a route or a start"),
                phrase("draw a route, or a start that looks along a free way"));
  }
  if (route->length() > kMaxLength) {
    throwBadInput(phrase("route"), "", fmt::format("{:.0f} m", route->length()),
                  phrase("at most {:.0f} m", kMaxLength));
  }
  for (const Building& building : map.buildings) checkClear(*route, building);
  Map own = map;
  if (!own.start) own.start = route->poseAt(0.0);
  if (own.route.empty()) {
    const Vec2 begin = own.start->position();
    own.route = {begin, begin + route->length() * unitVector(own.start->heading)};
  }
  RandomStream random(seed, 0, 0, kFromMap);
  return worldOf(std::move(own), seed, random);
}

}  // namespace handmap
